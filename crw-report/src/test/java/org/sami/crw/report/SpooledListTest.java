package org.sami.crw.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;

class SpooledListTest {
    private static FiringResult firing(int number) {
        return new FiringResult(number, number + 1, 10L * number, 1, "plan", "Überfahrt", "a", "m" + number);
    }

    private static <T> T thereAndBack(SpooledList.Format<T> format, T row) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        format.write(row, new DataOutputStream(bytes));
        DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes.toByteArray()));
        T read = format.read(in);
        assertThat(in.read()).isEqualTo(-1);
        return read;
    }

    @Test
    void givesBackWhatWasAddedInOrder() {
        SpooledList<FiringResult> spool = new SpooledList<>(RowFormats.FIRING);
        List<FiringResult> truth = new ArrayList<>();
        for (int i = 0; i < 5000; i++) {
            spool.add(firing(i));
            truth.add(firing(i));
        }

        assertThat(spool).hasSize(5000).isEqualTo(truth);
        assertThat(spool.get(4999)).isEqualTo(firing(4999));
        assertThat(spool.get(3)).isEqualTo(firing(3));
    }

    @Test
    void whatWasThereDoesNotChangeWhenMoreIsAdded() {
        SpooledList<FiringResult> spool = new SpooledList<>(RowFormats.FIRING);
        for (int i = 0; i < 700; i++) {
            spool.add(firing(i));
        }
        List<FiringResult> first = SpooledList.copyOf(spool);
        for (int i = 700; i < 2000; i++) {
            spool.add(firing(i));
        }

        assertThat(first).hasSize(700).endsWith(firing(699));
        assertThat(SpooledList.copyOf(first)).isSameAs(first);
        assertThatThrownBy(() -> first.get(700)).isInstanceOf(IndexOutOfBoundsException.class);
        assertThatThrownBy(() -> first.add(firing(1))).isInstanceOf(UnsupportedOperationException.class);
    }

    @Test
    void rowsComeBackAsTheyWere() throws Exception {
        DecisionResult open = new DecisionResult(1, 2, "Approve", "Go?", 5, OptionalLong.empty(), "", "", 0);
        DecisionResult closed =
                new DecisionResult(1, 2, "Approve", "x".repeat(100_000), 5, OptionalLong.of(9), "operator", "yes", 3);
        ReadingResult reading =
                new ReadingResult(7, "anna", "ctd", "temperature", List.of(1.5, -2.25), "°C", 45.1, 10.2);

        assertThat(thereAndBack(RowFormats.DECISION, open)).isEqualTo(open);
        assertThat(thereAndBack(RowFormats.DECISION, closed)).isEqualTo(closed);
        assertThat(thereAndBack(RowFormats.READING, reading)).isEqualTo(reading);
        assertThat(thereAndBack(RowFormats.FIRING, firing(3))).isEqualTo(firing(3));
    }
}
