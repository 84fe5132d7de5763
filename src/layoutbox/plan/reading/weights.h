// What speaks for and against a reading. Each has a name, which the table of examples (reading_test.txt) uses.
#pragma once

namespace layoutbox::offline::weight {

// Distance.
inline constexpr double kLevel = -0.7;            // for each thing that stands nearer
inline constexpr double kLevelAfterComma = -0.8;  // … after a comma for each step away from the clause's own thing
inline constexpr double kNoThing = 1.2;
inline constexpr double kLevelAlone = -0.2;  // … more where the reference is not said
inline constexpr double kSameSubject = 0.9;  // "on X and next to Y": of the same thing
inline constexpr double kDefiniteSubject = -0.6;
inline constexpr double kFiniteRoot = -1.2;    // "shelves full of books hang on the wall"
inline constexpr double kFromRoot = -1.5;      // "faces the bed from the wall"
inline constexpr double kKnownHost = -1.2;     // … or said to have something
inline constexpr double kPlaceAsHost = -2.0;   // "against the wall displaying plants"
inline constexpr double kKnownSubject = -2.0;  // what was there before is seldom placed by the way

// Sense.
inline constexpr double kNoSense = -6.0;   // the phrase says nothing of these two
inline constexpr double kUnlikely = -3.5;  // nothing of the kind is done
inline constexpr double kUsual = 1.0;
inline constexpr double kInStorage = 0.8;  // things are in what has an inside
inline constexpr double kOwnPart = 2;      // the tabletop is the table's
inline constexpr double kNotItsPart = -2;
inline constexpr double kSmallTogether = 0.5;  // a mouse by a keyboard
inline constexpr double kHangsThere = 0.5;     // on the wall
inline constexpr double kHeavyHung = -0.5;     // what is heavy is not hung
inline constexpr double kSmallHost = -0.7;     // a small thing seldom carries
inline constexpr double kSeatByTable = 0.5;
inline constexpr double kNoFront = -0.8;       // what has no front faces nothing
inline constexpr double kStandsBy = 1.2;       // a nightstand by a bed
inline constexpr double kNoReference = -3.0;   // not by such a thing
inline constexpr double kNotBeside = -1.2;     // small or hung things are seldom what one stands beside
inline constexpr double kOverSeat = -0.8;      // what hangs is seldom over a chair
inline constexpr double kLampOverTable = 0.3;  // … often over a table
inline constexpr double kBeforeHost = -1.2;    // what lies on a thing is not in front of that
inline constexpr double kSoftHost = -0.7;      // on beds and seats lies what is soft
inline constexpr double kItself = -50.0;
inline constexpr double kSmallByPlace = -1.8;  // a small thing of another one is seldom what stands at a wall
inline constexpr double kSeatOfTable = -2.0;   // a table with chairs in the corner: the table is
inline constexpr double kPlacedTwice = -1.5;   // two supports

inline constexpr double kSameSide = 1.8;  // left of X … right: of X

// Lists.
inline constexpr double kSubjectFollows = 1.6;
inline constexpr double kDisagrees = -2.0;  // a singular verb of several
inline constexpr double kAgrees = 1.5;      // a plural verb of what a bare "and" joins
inline constexpr double kPlaceFollows = 0.9;
inline constexpr double kNoJoiner = -2.5;
inline constexpr double kShareVerb = 1.5;
inline constexpr double kShareArticle = 2.5;
inline constexpr double kShareKind = 1.4;
inline constexpr double kShareNot = -0.7;
inline constexpr double kCarriedToo = 1.4;
inline constexpr double kNotCarried = -1.6;
inline constexpr double kBareAnd = 1.0;
inline constexpr double kEachHas = 1.2;
inline constexpr double kNearerList = -0.35;
inline constexpr double kListEnded = -3.0;

// Syntax.
inline constexpr double kTree = 0.4;      // whom a place belongs to
inline constexpr double kTreeList = 1.0;  // with whom a noun is listed

// References.
inline constexpr double kOwnHost = 1.0;  // "a bookcase with two books on the left"
inline constexpr double kMeansNobody = -10;
inline constexpr double kOrder = -0.45;        // for each candidate that comes before it
inline constexpr double kPartOfCarrier = 1.0;  // "on one corner"
inline constexpr double kNumber = -2.5;        // "it" of several, "them" of one

}  // namespace layoutbox::offline::weight
