package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.sami.spn.pattern.Pattern;
import org.sami.spn.pattern.Patterns;

/** What patterns say where they cannot be drawn. */
class PatternsTest extends DrawnPattern {
    @Test
    void patternsSayWhatToSelect() {
        first("OperatorCreateLocations");
        String last = placeBehind("OperatorCreatesLocations");

        assertThat(pattern("when-all-are-here").refusal(spot(last)))
                .contains("Neither robots nor tasks come to \"place 2\"");
        assertThat(pattern("until-none-is-left").refusal(spot(place("OperatorCreateLocations"))))
                .contains("Select the place where they are when they are done: nothing leads out of it");
        assertThat(pattern("ask-again-on-no").refusal(spot(last))).isPresent();
        assertThat(pattern("autonomy-decides-at-once").refusal(spot(last))).isPresent();
        for (Pattern pattern : Patterns.of(LIBRARY)) {
            assertThat(pattern.refusal(spot())).as(pattern.id()).isPresent();
            assertThat(pattern.help()).endsWith(".");
        }
    }
}
