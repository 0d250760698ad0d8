package org.sami.ui.table;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.sami.palette.Theme;
import org.sami.ui.check.Layout;
import org.sami.ui.check.TextFit;
import org.sami.ui.look.Icons;
import org.sami.ui.look.Look;
import org.sami.ui.look.Spacing;

@Isolated("the look is one for all windows of a process")
class RowTableTest {
    private record Row(String id, int value) {}

    private final RowTable<Row> table = new RowTable<>(
            "numbers",
            "Numbers appear here, one below the other, as soon as somebody has counted something",
            Row::id,
            List.of(RowColumn.words("Name", 0, Row::id), RowColumn.number("Value", 80, row -> row.value() + " m")));

    @Test
    void selectionStaysWithWhatARowIsAbout() {
        table.show(List.of(new Row("a", 1), new Row("b", 2)));
        table.selectKeys(Set.of("b"));

        table.show(List.of(new Row("b", 3), new Row("a", 1)));
        assertThat(table.selected()).contains(new Row("b", 3));

        table.show(List.of(new Row("c", 0), new Row("a", 1), new Row("b", 4)));
        assertThat(table.selected()).contains(new Row("b", 4));

        table.show(List.of(new Row("a", 1)));
        assertThat(table.selected()).isEmpty();
    }

    @Test
    void rowsAreHighEnoughForWetFingersWhereThatIsChosen() {
        table.show(List.of(new Row("a", 1)));
        Layout.layOut(table, 400, 200);
        int low = table.table().getRowHeight(0);

        Look.setHighRows(true);
        try {
            SwingUtilities.updateComponentTreeUI(table);
            Layout.layOut(table, 400, 200);

            assertThat(low).isLessThan(Spacing.HIT_TARGET_FIELD);
            assertThat(table.table().getRowHeight(0)).isEqualTo(Spacing.HIT_TARGET_FIELD);
        } finally {
            Look.setHighRows(false);
        }
    }

    @Test
    void onlyTheUsersSelectionsAreTold() {
        int[] told = {0};
        table.addSelectionListener(() -> told[0]++);

        table.show(List.of(new Row("a", 1), new Row("b", 2)));
        table.selectKeys(Set.of("b"));
        assertThat(told[0]).isZero();

        table.table().setRowSelectionInterval(0, 0);
        assertThat(told[0]).isPositive();
        assertThat(table.table().getValueAt(0, 1)).isEqualTo("1 m");
    }

    @Test
    void whatIsOfferedIsInViewWhateverSizeTheTableIsGiven() {
        offerRow20();

        Layout.layOut(table, 220, 200);
        assertThat(inView(20)).isTrue();

        Layout.layOut(table, 400, 110);
        assertThat(inView(20)).isTrue();

        table.table().setRowSelectionInterval(0, 0);
        table.getViewport().setViewPosition(new Point());
        Layout.layOut(table, 300, 120);
        assertThat(inView(20)).as("the user has selected something else").isFalse();
    }

    private void offerRow20() {
        table.show(IntStream.range(0, 30).mapToObj(i -> new Row("row " + i, i)).toList());
        table.offer(Set.of("row 20"));
    }

    private boolean inView(int row) {
        return table.getViewport().getViewRect().contains(table.table().getCellRect(row, 0, true));
    }

    @Test
    void wordsThatDoNotFitGoOnInFurtherLines() {
        table.show(
                List.of(new Row("short", 1), new Row("a text of which no letter is to be lost in a narrow table", 2)));

        Layout.layOut(table, 220, 200);

        assertThat(TextFit.faults(table)).isEmpty();
        assertThat(table.table().getRowHeight(1)).isGreaterThan(table.table().getRowHeight(0) + 10);

        Layout.layOut(table, 700, 200);
        assertThat(table.table().getRowHeight(1)).isEqualTo(table.table().getRowHeight(0));
    }

    @Test
    void wordsBesideAnIconGoOnInFurtherLinesAtTheLargestScaleToo() {
        try {
            Look.apply(Theme.LIGHT, 200);
            RowTable<Row> marked = withColumns(List.of(RowColumn.<Row>words("Name", 0, row -> "words beside an icon")
                    .withIcon(row -> Optional.of(Icons.small("alarm")))));
            for (int width = 340; width < 700; width += 7) {
                Layout.layOut(marked, width, 400);
                assertThat(TextFit.faults(marked)).as("at " + width + " px").isEmpty();
            }
        } finally {
            Look.apply(Theme.LIGHT, 100);
        }
    }

    @Test
    void aNarrowTableLeavesSpareColumnsOutTheLastOneFirst() {
        RowTable<Row> spare = withColumns(List.of(
                RowColumn.words("Name", 0, Row::id),
                RowColumn.<Row>number("One", 80, row -> "1").asSpare(),
                RowColumn.<Row>number("Two", 80, row -> "2").asSpare(),
                RowColumn.number("Value", 80, row -> row.value() + " m")));

        assertThat(heads(spare, 430)).containsExactly("Name", "One", "Two", "Value");
        assertThat(heads(spare, 350)).containsExactly("Name", "One", "Value");
        assertThat(heads(spare, 260)).containsExactly("Name", "Value");
        assertThat(spare.table().getValueAt(0, 1)).isEqualTo("1 m");
        assertThat(heads(spare, 430)).containsExactly("Name", "One", "Two", "Value");
    }

    @Test
    void aTableOfWholeRowsShowsSoManyOfThemAlsoWhereItIsLow() {
        String words = "words that need two lines at least, and even three of them where a table is as narrow as this";
        table.show(IntStream.range(0, 9)
                .mapToObj(i -> new Row("row " + i + (i % 2 == 0 ? "" : " has " + words), i))
                .toList());
        table.showWholeRows(3);
        table.offer(Set.of("row 8"));

        for (int height : new int[] {130, 200, 300, 420}) {
            Layout.layOut(table, 300, height);

            Rectangle seen = table.getViewport().getViewRect();
            int row = table.table().getRowHeight(0);
            assertThat(seen.height / row).as("rows in " + height + " px").isGreaterThanOrEqualTo(3);
            assertThat(seen.height % row).isZero();
            assertThat(seen.y % row).isZero();
            assertThat(inView(8)).isTrue();
        }
        assertThat(table.table().getRowHeight(0)).isGreaterThan(50);
    }

    @Test
    void inALowTableWordsGoOnInSoFewLinesThatTwoRowsAreSeen() {
        String words = "words that need several lines in a table that is as narrow as this one is here";
        table.show(List.of(new Row("one of many " + words, 1), new Row("another of many " + words, 2)));

        Layout.layOut(table, 300, 110);
        assertThat(inView(0) && inView(1)).isTrue();
        int low = table.table().getRowHeight(0);

        Layout.layOut(table, 300, 400);
        assertThat(table.table().getRowHeight(0)).isGreaterThan(low);

        table.show(List.of(new Row("short", 1), new Row("beside a long one " + words, 2)));
        Layout.layOut(table, 300, 110);
        assertThat(inView(0) && inView(1)).isTrue();
        assertThat(table.table().getRowHeight(1)).isGreaterThan(low);

        table.show(List.of(new Row("the only one " + words, 1)));
        Layout.layOut(table, 300, 110);
        assertThat(table.table().getRowHeight(0)).isGreaterThan(low);
    }

    @Test
    void aColumnOfWhatIsLeftHasItsRoomAlsoWhereColumnsOfWordsAreLeftOut() {
        RowTable<Row> narrow = withColumns(List.of(
                RowColumn.words("Code", 200, Row::id),
                RowColumn.<Row>words("Plan", 110, Row::id).asSpare(),
                RowColumn.words("What", 0, Row::id),
                RowColumn.<Row>words("Fix", 160, Row::id).asSpare()));

        assertThat(heads(narrow, 300)).containsExactly("Code", "What");
        assertThat(narrow.table().getColumnModel().getColumn(1).getWidth()).isGreaterThanOrEqualTo(170);
    }

    @Test
    void aTableThatIsScrolledStaysSoAlthoughARowWasOffered() {
        table.showWholeRows(3);
        offerRow20();
        Layout.layOut(table, 400, 200);
        assertThat(inView(20)).isTrue();

        for (int i = 0; i < 30; i++) {
            table.dispatchEvent(wheelUp());
        }
        table.invalidate();
        Layout.layOut(table, 400, 200);

        assertThat(inView(0)).isTrue();
    }

    @Test
    void anOfferedRowIsSeenWholeAlsoWhereTheViewWasMovedWithoutTheUser() {
        table.showWholeRows(3);
        offerRow20();
        Layout.layOut(table, 400, 200);

        table.getViewport().setViewPosition(new Point(0, table.table().getRowHeight(0) / 2));
        table.invalidate();
        Layout.layOut(table, 400, 200);

        assertThat(table.getViewport().getViewRect())
                .matches(seen -> seen.contains(table.table().getCellRect(20, 0, true)));
    }

    private MouseWheelEvent wheelUp() {
        return new MouseWheelEvent(
                table, MouseEvent.MOUSE_WHEEL, 0, 0, 100, 100, 0, false, MouseWheelEvent.WHEEL_UNIT_SCROLL, 3, -1);
    }

    @Test
    void theColumnThatIsLeftOutLastIsSeenAsLongAsOthersCanBeLeftOut() {
        RowTable<Row> spare = withColumns(List.of(
                RowColumn.words("Name", 0, Row::id),
                RowColumn.<Row>number("One", 80, row -> "1").asSpare(),
                RowColumn.<Row>number("Link", 80, row -> "2").asLastSpare()));

        assertThat(heads(spare, 350)).containsExactly("Name", "One", "Link");
        assertThat(heads(spare, 260)).containsExactly("Name", "Link");
        assertThat(heads(spare, 200)).containsExactly("Name");
        assertThat(heads(spare, 350)).containsExactly("Name", "One", "Link");
    }

    @Test
    void theTooltipOfARowSaysWhatColumnsHoldThatAreLeftOut() {
        RowTable<Row> spare = withColumns(List.of(
                RowColumn.words("Name", 120, Row::id),
                RowColumn.<Row>words("About", 0, row -> "it is " + row.value()).asSpare()));

        assertThat(heads(spare, 400)).containsExactly("Name", "About");
        assertThat(tip(spare)).isEqualTo("a");
        assertThat(heads(spare, 200)).containsExactly("Name");
        assertThat(tip(spare)).isEqualTo("a. About: it is 1");
    }

    private static String tip(RowTable<?> table) {
        return table.table()
                .getToolTipText(new MouseEvent(table.table(), MouseEvent.MOUSE_MOVED, 0, 0, 5, 5, 0, false));
    }

    @Test
    void theHintOfAnEmptyTableScrollsInALowPanel() {
        Layout.layOut(table, 160, 40);

        assertThat(TextFit.faults(table)).isEmpty();
        assertThat(table.getVerticalScrollBar().isVisible()).isTrue();
    }

    private static RowTable<Row> withColumns(List<RowColumn<Row>> columns) {
        RowTable<Row> made = new RowTable<>("numbers", "Numbers appear here", Row::id, columns);
        made.show(List.of(new Row("a", 1)));
        return made;
    }

    private static List<String> heads(RowTable<?> table, int width) {
        Layout.layOut(table, width, 200);
        return Collections.list(table.table().getColumnModel().getColumns()).stream()
                .map(column -> column.getHeaderValue().toString())
                .toList();
    }
}
