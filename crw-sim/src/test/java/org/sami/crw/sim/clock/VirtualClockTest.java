package org.sami.crw.sim.clock;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class VirtualClockTest {
    private final VirtualClock clock = new VirtualClock();
    private final List<String> ran = new ArrayList<>();

    @Test
    void runsActionsByTimeAndThenInOrderOfScheduling() {
        clock.at(30, () -> ran.add("c"));
        clock.at(10, () -> ran.add("a1"));
        clock.at(10, () -> ran.add("a2"));
        clock.at(20, () -> ran.add("b"));

        clock.runUntil(30);

        assertThat(ran).containsExactly("a1", "a2", "b", "c");
    }

    @Test
    void keepsOrderOfSchedulingAmongManyOfOneMoment() {
        SplittableRandom random = new SplittableRandom(7);
        List<List<Integer>> expected = new ArrayList<>();
        List<List<Integer>> seen = new ArrayList<>();
        for (int moment = 0; moment < 10; moment++) {
            expected.add(new ArrayList<>());
            seen.add(new ArrayList<>());
        }
        for (int i = 0; i < 1000; i++) {
            int number = i;
            int moment = random.nextInt(10);
            expected.get(moment).add(number);
            clock.at(moment, () -> seen.get(moment).add(number));
        }

        clock.runUntil(9);

        assertThat(seen).isEqualTo(expected);
    }

    @Test
    void runsWhatAnActionSchedulesForNowAfterWhatWaitsForNow() {
        clock.at(5, () -> {
            ran.add("first");
            clock.at(5, () -> ran.add("added"));
        });
        clock.at(5, () -> ran.add("second"));

        clock.runUntil(5);

        assertThat(ran).containsExactly("first", "second", "added");
    }

    @Test
    void showsTheTimeOfTheRunningAction() {
        List<Long> times = new ArrayList<>();
        clock.at(40, () -> times.add(clock.nowMs()));
        clock.at(70, () -> clock.after(5, () -> times.add(clock.nowMs())));

        clock.runUntil(100);

        assertThat(times).containsExactly(40L, 75L);
        assertThat(clock.nowMs()).isEqualTo(100);
    }

    @Test
    void leavesLaterActionsWaiting() {
        clock.at(11, () -> ran.add("late"));

        clock.runUntil(10);

        assertThat(ran).isEmpty();
        assertThat(clock.pending()).isEqualTo(1);
        assertThat(clock.nextTimeMs()).hasValue(11);
    }

    @Test
    void runsOneActionAtATime() {
        clock.at(3, () -> ran.add("a"));
        clock.at(4, () -> ran.add("b"));

        assertThat(clock.runNext()).isTrue();
        assertThat(ran).containsExactly("a");
        assertThat(clock.nowMs()).isEqualTo(3);
        assertThat(clock.runNext()).isTrue();
        assertThat(clock.runNext()).isFalse();
        assertThat(clock.nextTimeMs()).isEmpty();
    }

    @Test
    void goesOnAfterAnActionThatThrows() {
        clock.at(1, () -> {
            throw new IllegalStateException("broken");
        });
        clock.at(2, () -> ran.add("after"));

        assertThatThrownBy(() -> clock.runUntil(10)).hasMessage("broken");
        clock.runUntil(10);

        assertThat(ran).containsExactly("after");
    }

    @Test
    void refusesThePast() {
        clock.runUntil(100);

        assertThatThrownBy(() -> clock.at(99, () -> {})).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> clock.after(-1, () -> {})).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> clock.runUntil(99)).isInstanceOf(IllegalArgumentException.class);
    }
}
