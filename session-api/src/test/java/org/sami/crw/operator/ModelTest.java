package org.sami.crw.operator;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class ModelTest {

    /** Something that is counted, and how often a snapshot of it was made. */
    private static final class Counter extends Model<Integer> {
        private int count;
        private int taken;

        Counter() {
            super(0);
        }

        void countOn() {
            count++;
            change();
            publish();
        }

        @Override
        Integer take() {
            taken++;
            return count;
        }
    }

    private final Counter counter = new Counter();

    @Test
    void eachChangeMakesASnapshotForWhoeverMayAskFromAnotherThread() {
        counter.countOn();
        counter.countOn();

        assertThat(counter.taken).isEqualTo(2);
        assertThat(counter.snapshot()).isEqualTo(2);
    }

    @Test
    void whatNobodyAsksForIsNotMadeWhereTheOwnersThreadAloneAsks() {
        counter.takeWhenAsked();
        counter.countOn();
        counter.countOn();
        assertThat(counter.taken).isZero();

        assertThat(counter.snapshot()).isEqualTo(2);
        assertThat(counter.snapshot()).isEqualTo(2);
        assertThat(counter.taken).as("once for both").isEqualTo(1);

        counter.countOn();
        assertThat(counter.snapshot()).isEqualTo(3);
    }

    @Test
    void listenersHearOfEachChangeAllTheSame() {
        List<Integer> heard = new ArrayList<>();
        counter.takeWhenAsked();
        counter.countOn();
        counter.addListener(heard::add);

        counter.countOn();
        counter.countOn();

        assertThat(heard).containsExactly(2, 3);
    }
}
