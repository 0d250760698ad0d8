package org.sami.spn.model;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.sami.spn.edit.PlanBuilder;

class PlanElementsTest {
    @Test
    void verticesEdgesEventsAndSubMissionsAreElements() {
        Plan plan = new PlanBuilder("p")
                .start("a")
                .output("a", "Ask")
                .sub("a", "other")
                .transition("t", "Answered")
                .in("a", "t")
                .out("t", "z")
                .build();

        assertThat(plan.elementIds())
                .containsExactlyInAnyOrder("a", "a.Ask", "a.sub0", "t", "t.Answered", "z", "i0", "o0");
    }
}
