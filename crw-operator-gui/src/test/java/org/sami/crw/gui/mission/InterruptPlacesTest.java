package org.sami.crw.gui.mission;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.sami.crw.operator.mission.InterruptChoice;
import org.sami.spn.protocol.Priority;

class InterruptPlacesTest {
    private final InterruptPlaces places = new InterruptPlaces();

    private static InterruptChoice choice(long mission, String name, String noWayBack) {
        return new InterruptChoice(
                mission, "plan", name, false, Priority.MEDIUM, "", noWayBack, OptionalLong.empty(), "");
    }

    private static List<InterruptChoice> of(long mission, String... names) {
        List<InterruptChoice> choices = new ArrayList<>();
        for (String name : names) {
            choices.add(choice(mission, name, ""));
        }
        return choices;
    }

    @SafeVarargs
    private static List<InterruptChoice> all(List<InterruptChoice>... missions) {
        List<InterruptChoice> all = new ArrayList<>();
        for (List<InterruptChoice> each : missions) {
            all.addAll(each);
        }
        return all;
    }

    private List<String> shown(List<InterruptChoice> choices) {
        List<String> rows = new ArrayList<>();
        for (InterruptPlaces.Group group : places.show(choices)) {
            for (int i = 0; i < group.rows(); i++) {
                rows.add(
                        i < group.choices().size()
                                ? group.mission() + " " + group.choices().get(i).name()
                                : "-");
            }
        }
        return rows;
    }

    @Test
    void buttonsStayWhereTheyAreWhileOtherMissionsBeginAndEnd() {
        assertThat(shown(all(of(1, "swap", "abort"), of(2, "swap")))).containsExactly("1 swap", "1 abort", "2 swap");

        assertThat(shown(of(2, "swap"))).containsExactly("-", "-", "2 swap");
        assertThat(shown(all(of(2, "swap"), of(3, "a", "b", "c"))))
                .containsExactly("-", "-", "2 swap", "3 a", "3 b", "3 c");
        assertThat(shown(all(of(2, "swap"), of(3, "a", "b", "c"), of(4, "x"))))
                .containsExactly("4 x", "-", "2 swap", "3 a", "3 b", "3 c");
        assertThat(shown(of(2, "swap"))).containsExactly("-", "-", "2 swap");
        assertThat(shown(List.of())).isEmpty();
        assertThat(shown(of(5, "y"))).containsExactly("5 y");
    }

    @Test
    void whatCannotBeUndoneStandsApartAfterTheOthers() {
        assertThat(shown(List.of(choice(1, "abort", "Nothing leads back"), choice(1, "swap", ""))))
                .containsExactly("1 swap", "1 abort");
    }

    @Test
    void aMissionKeepsItsKeysUntilItEndsAndNoKeyMeansAnotherInterrupt() {
        places.show(all(of(1, "swap", "abort"), of(2, "swap")));
        assertThat(places.number(1, "swap")).isEqualTo(OptionalInt.of(0));
        assertThat(places.number(2, "swap")).isEqualTo(OptionalInt.of(2));

        places.show(of(2, "swap"));
        assertThat(places.number(2, "swap")).isEqualTo(OptionalInt.of(2));
        places.show(all(of(2, "swap"), of(3, "alarm", "swap")));

        assertThat(places.number(3, "alarm")).isEqualTo(OptionalInt.of(3));
        assertThat(places.number(3, "swap")).isEqualTo(OptionalInt.of(0));
        assertThat(places.name(1)).contains("abort");
        assertThat(places.mission(1)).isEmpty();
    }
}
