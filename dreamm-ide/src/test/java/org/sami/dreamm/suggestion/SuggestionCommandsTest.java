package org.sami.dreamm.suggestion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.sami.dreamm.OnEventThread;
import org.sami.dreamm.context.AuthorQuestion;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.profile.Profile;
import org.sami.spn.edit.EdgeEdit;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.ui.command.Command;

/** Suggestions for the selected edge are shown on the net one by one; one is written as one edit, or none. */
@ExtendWith(OnEventThread.class)
class SuggestionCommandsTest {
    private static final DomainLibrary BOATS =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    private static final int STATES = 20;

    private final Deque<Runnable> work = new ArrayDeque<>();
    private DreammContext context;
    private String edge = "";

    @BeforeEach
    void openAPlanWithAnEdgeWithoutRequirements() {
        Project sound = BOATS.projectOf("station-keep").orElseThrow();
        Plan plan = sound.plans().get(0);
        edge = plan.inEdges().get(0).id();
        Project project = new EdgeEdit.SetInRequirements(plan.id(), edge, List.of())
                .apply(sound, BOATS.vocabulary())
                .project()
                .orElseThrow();
        context = new DreammContext(
                BOATS, new ProjectDocument(BOATS.vocabulary(), project, Optional.empty()), Profile.ALL);
        context.editor().open(plan.id());
        SuggestionCommands.addTo(context, work::add, Runnable::run, STATES);
    }

    @AfterEach
    void close() {
        context.close();
    }

    private Plan plan() {
        return context.editor().plan().orElseThrow();
    }

    private Command suggest() {
        context.commands().refresh();
        return context.commands().get("edge-suggest");
    }

    private AuthorQuestion question() {
        return context.questions().current().orElseThrow();
    }

    private void choose(String label) {
        AuthorQuestion question = question();
        context.questions()
                .answer(
                        question,
                        question.choices().stream()
                                .filter(choice -> choice.label().equals(label))
                                .findFirst()
                                .orElseThrow());
    }

    private InEdge edge() {
        return plan().inEdges().get(0);
    }

    @Test
    void bestSuggestionIsShownAndWrittenAsOneEdit() {
        Plan before = plan();
        context.editor().select(List.of(edge));
        suggest().run();
        assertThat(question().choices())
                .singleElement()
                .satisfies(choice -> assertThat(choice.label()).isEqualTo("Stop"));

        work.remove().run();

        assertThat(question().text()).startsWith("1 of ").contains("1 finding fewer");
        assertThat(context.preview().shown()).isPresent();
        assertThat(plan()).isEqualTo(before);

        choose("Write it");

        assertThat(edge().requirements()).isNotEmpty();
        assertThat(context.preview().shown()).isEmpty();
        assertThat(context.questions().current()).isEmpty();
        context.undo();
        assertThat(plan()).isEqualTo(before);
    }

    @Test
    void suggestionsAreGoneThroughAndLeft() {
        Plan before = plan();
        context.editor().select(List.of(edge));
        suggest().run();
        work.remove().run();
        String first = question().text();

        choose("Next");
        assertThat(question().text()).startsWith("2 of ").isNotEqualTo(first);
        choose("Back");
        assertThat(question().text()).isEqualTo(first);
        choose("Leave it");

        assertThat(context.questions().current()).isEmpty();
        assertThat(context.preview().shown()).isEmpty();
        assertThat(plan()).isEqualTo(before);
    }

    @Test
    void searchEndsWhenSomethingElseIsSelected() {
        context.editor().select(List.of(edge));
        suggest().run();

        context.editor().select(List.of(edge().place()));
        work.remove().run();

        assertThat(context.questions().current()).isEmpty();
        assertThat(context.preview().shown()).isEmpty();
    }

    @Test
    void commandSaysThatItNeedsOneEdge() {
        context.editor().select(List.of(edge().place()));

        assertThat(suggest().isEnabled()).isFalse();
        assertThat(suggest().whyNot()).contains("select one edge: requirements are suggested for it");
    }
}
