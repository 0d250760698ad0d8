package org.sami.crw.gui.boat;

import java.util.HashSet;
import java.util.function.Function;
import javax.swing.Icon;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.gui.context.RobotIcons;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.IconPair;
import org.sami.ui.look.Icons;
import org.sami.ui.look.MarkIcon;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;

/** What all tables with a row for each boat share: the column of names with their marks, and the session's selection. */
public final class BoatNameColumn {
    private static final int NAME_WIDTH = 92;
    private static final int KIND_PX = 14;
    private static final int KIND_WIDTH = KIND_PX + 8; // with the gap before it

    private BoatNameColumn() {}

    /**
     * The column with each boat's mark and name; what is no boat yet has no mark.
     *
     * @param boat the boat of a row
     */
    public static <R> RowColumn<R> names(OperatorContext context, Function<R, String> boat) {
        int width = context.robots() == RobotKind.ROBOT ? NAME_WIDTH + KIND_WIDTH : NAME_WIDTH;
        return RowColumn.words(context.say("Boat"), width, boat)
                .keepingEnds() // addresses of one network differ there
                .withIcon(row ->
                        context.models().fleet().boat(boat.apply(row)).map(known -> icon(context, known.boat())));
    }

    /** A robot's mark and, where both kinds are together, what it is. */
    static Icon icon(OperatorContext context, String robot) {
        Icon mark = new MarkIcon(context.marks().of(robot));
        return context.robots() == RobotKind.ROBOT
                ? new IconPair(mark, Icons.of(RobotIcons.one(context.kindOf(robot)), KIND_PX, SemanticColor.TEXT))
                : mark;
    }

    /** Keeps the selected rows of a table and the session's selected boats the same; rows are keyed by their boats. */
    public static <R> void shareSelection(OperatorContext context, RowTable<R> table, Function<R, String> boat) {
        table.addSelectionListener(() -> context.boats()
                .select(table.allSelected().stream()
                        .map(boat)
                        .filter(one -> context.models().fleet().boat(one).isPresent())
                        .toList()));
        context.boats()
                .addListener(
                        () -> table.selectKeys(new HashSet<>(context.boats().boats())));
    }
}
