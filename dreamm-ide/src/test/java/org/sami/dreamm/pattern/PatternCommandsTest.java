package org.sami.dreamm.pattern;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.sami.dreamm.OnEventThread;
import org.sami.dreamm.canvas.ModelView;
import org.sami.dreamm.context.AuthorQuestion;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.profile.Profile;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.ui.command.Command;

/** A pattern is shown on the net before it is drawn, is drawn as one edit, and leaves nothing behind where it is not. */
@ExtendWith(OnEventThread.class)
class PatternCommandsTest {
    private static final DomainLibrary BOATS =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    private DreammContext context;
    private ModelView view;

    @BeforeEach
    void openAPlan() {
        context = new DreammContext(
                BOATS,
                new ProjectDocument(
                        BOATS.vocabulary(), BOATS.projectOf("explore-area").orElseThrow(), Optional.empty()),
                Profile.ALL);
        view = new ModelView(context);
        PatternCommands.addTo(context);
    }

    @AfterEach
    void close() {
        context.close();
    }

    private Plan plan() {
        return context.editor().plan().orElseThrow();
    }

    private Command watch() {
        context.commands().refresh();
        return context.commands().get("pattern-battery-watch-around-this");
    }

    private Set<String> drawn() {
        return Set.copyOf(
                view.net().drawing().vertices().stream().map(v -> v.id()).toList());
    }

    private AuthorQuestion question() {
        return context.questions().current().orElseThrow();
    }

    @Test
    void patternIsShownOnTheNetBeforeItIsDrawn() {
        Project before = context.document().project();
        Set<String> vertices = drawn();
        context.editor().select(List.of("explore"));

        watch().run();

        assertThat(context.document().project()).isEqualTo(before);
        assertThat(drawn()).hasSize(vertices.size() + 5).containsAll(vertices);
        assertThat(question().text()).contains("Battery watch around this", "4 transitions", "1 place");
    }

    @Test
    void patternIsDrawnAsOneEditAndUndoneAsOne() {
        Plan before = plan();
        context.editor().select(List.of("explore"));
        watch().run();

        context.questions().answer(question(), question().choices().get(0));

        assertThat(plan().transitions()).hasSize(before.transitions().size() + 4);
        assertThat(context.preview().shown()).isEmpty();
        assertThat(context.questions().current()).isEmpty();
        context.undo();
        assertThat(plan()).isEqualTo(before);
    }

    @Test
    void previewGoesWhenTheAuthorLeavesItOrSelectsSomethingElse() {
        Plan before = plan();
        Set<String> vertices = drawn();
        context.editor().select(List.of("explore"));
        watch().run();
        context.questions().dismiss(question());
        assertThat(drawn()).isEqualTo(vertices);

        watch().run();
        context.editor().select(List.of("select"));

        assertThat(drawn()).isEqualTo(vertices);
        assertThat(context.questions().current()).isEmpty();
        assertThat(plan()).isEqualTo(before);
    }

    @Test
    void patternThatCannotStandAtTheSelectionSaysWhy() {
        context.editor().select(List.of("end"));

        assertThat(watch().isEnabled()).isFalse();
        assertThat(watch().whyNot()).contains("The mission ends in \"End\"");
    }

    @Test
    void profileHidesPatterns() {
        context.close();
        context = new DreammContext(
                BOATS,
                new ProjectDocument(
                        BOATS.vocabulary(), BOATS.projectOf("explore-area").orElseThrow(), Optional.empty()),
                new Profile("lesson", List.of("pattern-*"), List.of(), List.of()));
        PatternCommands.addTo(context);

        assertThat(context.commands().find("pattern-when-all-are-here").filter(c -> !c.isHidden()))
                .isEmpty();
    }
}
