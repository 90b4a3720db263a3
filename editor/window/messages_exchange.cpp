// What importing files of other programs has to say. Of what was left out, %4 says how often and in which lines of the
// file, %3 are names.
#include "editor/window/messages_table.h"

#include <QtGlobal>

namespace spacetow {

namespace {

constexpr MessageText exchange[] = {
    {"import-not-xml", QT_TRANSLATE_NOOP("messages", "The file is not sound XML: line %1, column %2: %3")},
    {"import-entities", QT_TRANSLATE_NOOP("messages", "The file declares entities of its own (line %1), which are not "
                                                      "read because they can be made to grow without end. Save it "
                                                      "as plain SVG, for example with Inkscape, and try again.")},
    {"import-too-deep",
     QT_TRANSLATE_NOOP(
         "messages", "Elements of the file lie more than %1 deep in one another. Ungroup some of them, and try again."),
     nullptr, "n"},
    {"import-too-many",
     QT_TRANSLATE_NOOP("messages", "The file draws more than %1 pieces, which is more than can be imported. Take out "
                                   "what the level does not need, and try again."),
     nullptr, "n"},
    {"import-stopped", QT_TRANSLATE_NOOP("messages", "The import was stopped; nothing was changed.")},
    {"import-compressed", QT_TRANSLATE_NOOP("messages", "The file is compressed. Unpack it first, or save it as plain "
                                                        "SVG instead of SVGZ.")},
    {"import-unknown", QT_TRANSLATE_NOOP("messages", "This is no file that can be imported: SVG drawings, maps of "
                                                     "Tiled (.tmx, .tmj) and scenes of R.U.B.E. (.json) can.")},
    {"import-level", QT_TRANSLATE_NOOP("messages", "This is a level already: open it instead of importing it.")},
    {"import-tileset", QT_TRANSLATE_NOOP("messages", "This is a tileset or a template of Tiled, which draws nothing. "
                                                     "Import a map.")},
    {"import-too-far",
     QT_TRANSLATE_NOOP("messages", "At this scale something would lie more than %1 m away. Choose a "
                                   "smaller scale."),
     nullptr, "n"},
    {"import-too-many-vertices",
     QT_TRANSLATE_NOOP("messages", "The result would have more than %1 vertices. Choose a larger tolerance."), nullptr,
     "n"},
    {"import-nothing",
     QT_TRANSLATE_NOOP("messages", "There is nothing in this file that could become part of a level.")},
    {"import-text", QT_TRANSLATE_NOOP("messages", "Text was left out (%4). Turn it into paths to have it.")},
    {"import-image", QT_TRANSLATE_NOOP("messages", "Pictures were left out (%4).")},
    {"import-foreign", QT_TRANSLATE_NOOP("messages", "Content in another language than SVG was left out (%4).")},
    {"import-animation", QT_TRANSLATE_NOOP("messages", "Animations were left out (%4).")},
    {"import-script", QT_TRANSLATE_NOOP("messages", "Scripts were left out (%4).")},
    {"import-style", QT_TRANSLATE_NOOP("messages", "Some selectors of a style sheet are not understood (%4): what they "
                                                   "say of fill and stroke was not taken over.")},
    {"import-hidden", QT_TRANSLATE_NOOP("messages", "What is not displayed was left out (%4).")},
    {"import-unpainted", QT_TRANSLATE_NOOP("messages", "Shapes without fill and stroke were left out (%4).")},
    {"import-transform", QT_TRANSLATE_NOOP("messages", "A transform is not understood and was left out (%4).")},
    {"import-clip",
     QT_TRANSLATE_NOOP("messages", "Clips and masks were not applied: shapes are there as a whole (%4).")},
    {"import-window",
     QT_TRANSLATE_NOOP("messages",
                       "What drawings within the drawing hide beyond their borders is there as well (%4).")},
    {"import-stroke-width",
     QT_TRANSLATE_NOOP("messages", "The width of wide strokes was not taken over: they are walls "
                                   "without thickness (%4). “Stroke to Path” of Inkscape makes "
                                   "areas of them.")},
    {"import-filter", QT_TRANSLATE_NOOP("messages", "Filters were not applied (%4).")},
    {"import-use",
     QT_TRANSLATE_NOOP("messages", "References to what is not in the file, or to themselves, were left out (%4): %3")},
    {"import-bad-data",
     QT_TRANSLATE_NOOP("messages", "The data of shapes has a mistake; they are there up to it (%4).")},
    {"import-flat", QT_TRANSLATE_NOOP("messages", "Shapes without any extent were left out (%4).")},
    {"import-holes",
     QT_TRANSLATE_NOOP("messages", "Areas with holes, or in several parts, were cut into several polygons (%4).")},
    {"import-large-polygon",
     QT_TRANSLATE_NOOP(
         "messages",
         "Polygons of more than 1024 vertices became walls (%4). A larger tolerance makes fewer vertices.")},
    {"import-tangled", QT_TRANSLATE_NOOP("messages", "Areas that cross themselves very often became walls (%4).")},
    {"import-tiles",
     QT_TRANSLATE_NOOP(
         "messages",
         "Layers of tiles were left out, for a level has no tiles: %3 (%4). Objects of object layers are taken over.")},
    {"import-image-layer", QT_TRANSLATE_NOOP("messages", "Layers of pictures were left out: %3 (%4).")},
    {"import-tilesets", QT_TRANSLATE_NOOP("messages", "Tilesets are not needed and were not read: %3.")},
    {"import-tile-objects", QT_TRANSLATE_NOOP("messages", "Objects that are tiles were left out (%4).")},
    {"import-templates",
     QT_TRANSLATE_NOOP(
         "messages",
         "Objects made of templates were left out, for these are in other files (%4). Detach them in Tiled.")},
    {"import-tiled-form",
     QT_TRANSLATE_NOOP("messages", "Objects of a form that is not known here were left out (%4).")},
    {"import-points",
     QT_TRANSLATE_NOOP("messages",
                       "Points were left out (%4): only those of the class “ship” or “payload” become something.")},
    {"import-property", QT_TRANSLATE_NOOP("messages", "Properties that mean nothing here were left out (%4): %3.")},
    {"import-opacity", QT_TRANSLATE_NOOP("messages", "The opacity of layers was not taken over: %3 (%4).")},
    {"import-parallax", QT_TRANSLATE_NOOP("messages", "The parallax of layers was not taken over: %3 (%4).")},
    {"import-gravity", QT_TRANSLATE_NOOP("messages", "Gravity was not taken over (%4): the level keeps its own.")},
    {"import-range",
     QT_TRANSLATE_NOOP("messages", "Numbers that a level cannot have were brought into its range (%4): %3.")},
    {"import-fixture", QT_TRANSLATE_NOOP("messages", "Fixtures without a sound shape were left out (%4).")},
    {"import-filter-groups", QT_TRANSLATE_NOOP("messages", "Group indices of filters were not taken over (%4): %3")},
    {"import-material",
     QT_TRANSLATE_NOOP("messages",
                       "Fixtures of one body differ in material or filter: those of the first were taken (%4): %3")},
    {"import-sensors",
     QT_TRANSLATE_NOOP("messages", "Sensors of bodies that also have solid fixtures were left out (%4): %3")},
    {"import-body-setting",
     QT_TRANSLATE_NOOP("messages", "Settings of bodies that mean nothing here were left out (%4): %3")},
    {"import-no-fixture", QT_TRANSLATE_NOOP("messages", "Bodies without fixtures were left out (%4): %3")},
    {"import-joint", QT_TRANSLATE_NOOP("messages", "Joints that no connector can be were left out (%4): %3")},
    {"import-rigid-joint", QT_TRANSLATE_NOOP("messages", "Rigid joints became stiff connectors (%4): %3")},
    {"import-one-only", QT_TRANSLATE_NOOP("messages", "The level has a ship, a payload or a finish already; those of "
                                                      "the file were left out.")},
    {"import-tags-full", QT_TRANSLATE_NOOP("messages", "All 32 tags are taken; these were left out: %3")},
};

} // namespace

std::span<const MessageText> exchangeTexts() {
    return exchange;
}

} // namespace spacetow
