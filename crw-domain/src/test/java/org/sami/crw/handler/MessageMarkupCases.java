package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import org.sami.spn.value.TextValue;

/** What markups do to messages. */
final class MessageMarkupCases {
    private MessageMarkupCases() {}

    static void add(MarkupCatalogue catalogue) {
        catalogue.shows("Keyword.source", "the message replaces the one with its keyword, and no other", () -> {
            PlanScene scene = new PlanScene(
                    telling(telling(telling(new PlanSketch(), "first", "link"), "other", "battery"), "second", "link"),
                    0);

            assertThat(scene.messages()).containsExactlyInAnyOrder("other", "second");
            assertThat(scene.world.operator.messages().groups())
                    .filteredOn(group -> group.keyword().equals("link"))
                    .singleElement()
                    .satisfies(group -> assertThat(group.count()).isEqualTo(2));
        });
    }

    private static PlanSketch telling(PlanSketch plan, String text, String keyword) {
        return plan.asks("telling", "DisplayMessage", "message", new TextValue(text))
                .marked("Keyword", "source", new TextValue(keyword));
    }
}
