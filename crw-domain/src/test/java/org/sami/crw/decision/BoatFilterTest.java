package org.sami.crw.decision;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.TextValue;

class BoatFilterTest {
    private static final Map<String, String> DESCRIPTIONS = Map.of("boat-1", "SHORE", "boat-2", "WATER, deployed");

    @ParameterizedTest
    @CsvSource({
        "INCLUDE, shore,    1, boat-1",
        "INCLUDE, WATER,    1, boat-2",
        "EXCLUDE, SHORE,    1, boat-2 spare",
        "INCLUDE, spare,    1, spare",
        "INCLUDE, boat,     2, boat-1 boat-2",
        "INCLUDE, spare,    2, boat-1 boat-2 spare", // fewer than must be chosen
        "INCLUDE, nothing,  0, boat-1 boat-2 spare",
    })
    void boatsAreOfferedByNameAndDescription(String action, String source, int least, String offered) {
        Decision decision = choice(least, filter(action, source));

        assertThat(offered(decision)).isEqualTo(List.of(offered.split(" ")));
    }

    @Test
    void severalFiltersAllCount() {
        assertThat(offered(choice(1, filter("INCLUDE", "boat"), filter("EXCLUDE", "shore"))))
                .containsExactly("boat-2");
    }

    @Test
    void otherQuestionsStayAsTheyAre() {
        Decision decision = choice(1).asking(new Question.Approve());

        assertThat(BoatFilter.narrowed(decision, boat -> Optional.empty())).isSameAs(decision);
    }

    private static List<String> offered(Decision decision) {
        Decision narrowed = BoatFilter.narrowed(decision, boat -> Optional.ofNullable(DESCRIPTIONS.get(boat)));
        return ((Question.ChooseProxies) narrowed.question()).proxies();
    }

    private static Decision choice(int least, MarkupSpec... markups) {
        return new Decision(
                1,
                1,
                1,
                "OperatorSelectBoat",
                "Which?",
                new Question.ChooseProxies(List.of("boat-1", "boat-2", "spare"), least, 3),
                Optional.empty(),
                OptionalLong.empty(),
                Priority.MEDIUM,
                new ArrayList<>(List.of(markups)));
    }

    private static MarkupSpec filter(String action, String source) {
        return new MarkupSpec(
                "Filter", Map.of("source", new TextValue(source), "action", new EnumValue("FilterAction", action)));
    }
}
