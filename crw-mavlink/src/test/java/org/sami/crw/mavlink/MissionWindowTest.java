package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.mavlink.mission.MissionItem;

class MissionWindowTest {
    private static final int LONG = 2_002;
    private static final int JUMP = 177;
    private static final int KEEPS_PLACE = 17;

    /** Home, waypoints, and an item that keeps the place of the last one. */
    private static List<MissionItem> list(int size) {
        return IntStream.range(0, size)
                .mapToObj(i -> new MissionItem(
                        i, i == size - 1 ? KEEPS_PLACE : 16, 3, 45 + Math.min(i, size - 2) * 1e-4, 10, 0, 0, 0, 0, 0))
                .toList();
    }

    /** Drives along what a vehicle holds, from a slot to the item at which it keeps its place; the slots of waypoints that it has passed. */
    private static List<Integer> drive(List<MissionItem> held, int from) {
        List<Integer> passed = new ArrayList<>();
        int slot = from;
        while (held.get(slot).command() != KEEPS_PLACE) {
            if (held.get(slot).command() == JUMP) {
                slot = (int) held.get(slot).param1();
            } else {
                passed.add(slot);
                slot++;
            }
        }
        return passed;
    }

    @Test
    void shortListIsHeldWhole() {
        List<MissionItem> all = list(MissionWindow.MOST_WHOLE);
        MissionWindow window = MissionWindow.of(all, 300);

        assertThat(window.items()).isEqualTo(all);
        assertThat(window.slot(300)).isEqualTo(300);
        assertThat(window.item(300)).isEqualTo(300);
        assertThat(window.next(600)).isEmpty();
    }

    @Test
    void longListIsHeldWholeWhereThereIsRoom() {
        List<MissionItem> all = list(LONG);
        MissionWindow window = MissionWindow.whole(all);

        assertThat(window.items()).isEqualTo(all);
        assertThat(window.slot(1_300)).isEqualTo(1_300);
        assertThat(window.item(1_300)).isEqualTo(1_300);
        assertThat(window.has(1)).isTrue();
        assertThat(window.has(LONG - 1)).isTrue();
        assertThat(window.next(1_300)).isEmpty();
        assertThat(MissionWindow.found(all, all, 0).orElseThrow().size()).isEqualTo(LONG);
    }

    @Test
    void gateOfAPathInTheAirIsAsHighAsThePlaceBeforeIt() {
        List<MissionItem> all = IntStream.range(0, LONG)
                .mapToObj(i -> new MissionItem(i, 16, 3, 45 + i * 1e-4, 10, 20 + i * 0.01, 0, 0, 0, 0))
                .toList();
        MissionWindow window = MissionWindow.of(all, 1);

        MissionItem stop = window.items().get(window.slot(window.stop()));

        assertThat(stop.command()).isEqualTo(KEEPS_PLACE);
        assertThat(stop.heightM()).isEqualTo(all.get(window.stop() - 1).heightM());
    }

    @ParameterizedTest
    @ValueSource(ints = {603, 700, 801, 1_000, 1_001, LONG, 20_002})
    void vehiclePassesEachItemOnceThroughAllParts(int size) {
        List<MissionItem> all = list(size);
        MissionWindow window = MissionWindow.of(all, 1);
        List<MissionItem> passed = new ArrayList<>();
        int item = 1;

        while (item < size - 1) {
            assertThat(window.items()).hasSizeLessThanOrEqualTo(MissionWindow.SLOTS + 2);
            List<MissionItem> held = window.items();
            for (int slot : drive(held, window.slot(item))) {
                assertThat(window.item(slot)).isEqualTo(item);
                passed.add(held.get(slot).at(item));
                item++;
            }
            while (window.next(item).isPresent()) {
                MissionWindow next = window.next(item).get();
                assertThat(drive(next.items(), next.slot(window.stop() - 1))).hasSize(1); // up to the old stop
                window = next.stoppingAtItsEnd();
            }
        }

        assertThat(passed).isEqualTo(all.subList(1, size - 1));
    }

    @Test
    void nothingThatTheVehicleHasNotLeftBehindIsOverwritten() {
        List<MissionItem> all = list(LONG);
        MissionWindow window = MissionWindow.of(all, 1);

        for (int item = 1; item < LONG - 1; item++) {
            for (Optional<MissionWindow> next = window.next(item); next.isPresent(); next = window.next(item)) {
                window = next.get().stoppingAtItsEnd();
            }
            assertThat(window.has(item)).isTrue();
            assertThat(window.has(Math.max(1, item - 5))).isTrue();
            assertThat(window.stop() - item).isGreaterThan(Math.min(280, LONG - 1 - item));
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 12, 390, 391, 400, 1_111, 1_599, 1_700, 2_000})
    void partForAnItemInTheMidstHasIt(int item) {
        MissionWindow window = MissionWindow.of(list(LONG), item);

        assertThat(window.has(item)).isTrue();
        assertThat(window.item(window.slot(item))).isEqualTo(item);
        assertThat(window.isHeld(window.items())).isTrue();
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 150, 700, 1_580, 1_700, 2_000})
    void partThatAVehicleHoldsIsFound(int item) {
        List<MissionItem> all = list(LONG);
        MissionWindow window = MissionWindow.of(all, item);

        MissionWindow found = MissionWindow.found(all, window.items(), 0).orElseThrow();

        assertThat(found.to()).isEqualTo(window.to());
        assertThat(found.isComplete()).isTrue();
    }

    @Test
    void partThatABaseHadBegunToSendIsFoundWithItsStop() {
        List<MissionItem> all = list(LONG);
        MissionWindow next = MissionWindow.of(all, 1).next(350).orElseThrow();
        List<MissionItem> half = new ArrayList<>(MissionWindow.of(all, 1).items());
        IntStream.range(1, 40).forEach(slot -> half.set(slot, next.items().get(slot)));

        MissionWindow found = MissionWindow.found(all, half, 0).orElseThrow();

        assertThat(found.stop()).isEqualTo(MissionWindow.SLOTS);
        assertThat(found.isComplete()).isFalse();
        assertThat(found.next(350)).contains(found);
    }

    @Test
    void hintTellsTwoLapsApart() {
        List<MissionItem> all = new ArrayList<>(list(2 * LONG));
        int lap = 2 * MissionWindow.SLOTS;
        IntStream.range(1, lap + 1).forEach(i -> all.set(i + lap, all.get(i).at(i + lap)));
        MissionWindow second = MissionWindow.of(all, 1_501);

        assertThat(MissionWindow.found(all, second.items(), second.to())
                        .orElseThrow()
                        .to())
                .isEqualTo(second.to());
        assertThat(MissionWindow.found(all, second.items(), 0).orElseThrow().to())
                .isLessThan(second.to());
    }

    @Test
    void anotherMissionIsNotFound() {
        List<MissionItem> all = list(LONG);
        List<MissionItem> other = new ArrayList<>(MissionWindow.of(all, 1).items());
        other.set(77, MissionItem.waypoint(77, 46, 10, 0, 0));

        assertThat(MissionWindow.found(all, other, 0)).isEmpty();
        assertThat(MissionWindow.found(all, all.subList(0, 300), 0)).isEmpty();
        assertThat(MissionWindow.found(all, List.of(), 0)).isEmpty();
    }
}
