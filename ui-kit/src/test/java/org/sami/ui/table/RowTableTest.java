package org.sami.ui.table;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

class RowTableTest {
    private record Row(String id, int value) {}

    private final RowTable<Row> table = new RowTable<>(
            "numbers",
            "Numbers appear here",
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
}
