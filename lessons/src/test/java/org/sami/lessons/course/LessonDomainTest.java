package org.sami.lessons.course;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.sequence.EventCategory;
import org.sami.spn.sequence.Sequence;

class LessonDomainTest {
    private static final DomainLibrary WHOLE =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    private final DomainLibrary part = new LessonDomain(
                    Set.of("ProxyExecutePath", "ProxyPathCompleted", "StartSystemTimer", "TimerExpired"),
                    Set.of(),
                    Set.of())
            .of(WHOLE);

    @Test
    void onlyWhatWasIntroducedIsThere() {
        assertThat(part.vocabulary().events().keySet())
                .containsExactlyInAnyOrder(
                        "ProxyExecutePath", "ProxyPathCompleted", "StartSystemTimer", "TimerExpired");
        assertThat(part.vocabulary().markups()).isEmpty();
        assertThat(part.vocabulary().taskClasses()).isEmpty();
        assertThat(part.projects()).isEmpty();
        assertThat(part.vocabulary().types()).isEqualTo(WHOLE.vocabulary().types());
    }

    @Test
    void anAnswerThatWasNotIntroducedIsNone() {
        assertThat(WHOLE.vocabulary().event("ProxyExecutePath").orElseThrow().answers())
                .contains("ProxyPathFailed");
        assertThat(part.vocabulary().event("ProxyExecutePath").orElseThrow().answers())
                .containsExactly("ProxyPathCompleted");
        assertThat(part.authoring().ofOutput("ProxyExecutePath").orElseThrow().inputs())
                .doesNotContain("ProxyPathFailed");
    }

    @Test
    void groupsAndSequencesSpeakOfNothingElse() {
        Set<String> known = part.vocabulary().events().keySet();
        assertThat(part.authoring().categories())
                .isNotEmpty()
                .allSatisfy(group -> assertThat(known).containsAll(group.events()));
        assertThat(part.authoring().groups(part.vocabulary()))
                .extracting(EventCategory::events)
                .allSatisfy(events -> assertThat(known).containsAll(events));
        assertThat(part.authoring().sequences().stream().map(Sequence::event).collect(Collectors.toSet()))
                .isSubsetOf(known);
        assertThat(part.authoring().sequences().stream()
                        .filter(Sequence.Manual.class::isInstance)
                        .map(Sequence.Manual.class::cast)
                        .flatMap(manual -> manual.part().places().stream())
                        .flatMap(place -> place.outputs().stream())
                        .map(event -> event.type()))
                .allMatch(known::contains);
    }
}
