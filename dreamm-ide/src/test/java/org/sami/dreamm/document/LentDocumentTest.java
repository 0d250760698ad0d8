package org.sami.dreamm.document;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Project;

/** Another project can be shown in place of the author's own, which comes back with its history and its file. */
class LentDocumentTest {
    private static final Optional<Path> FILE = Optional.of(Path.of("mine.json"));

    private final ProjectDocument document = new ProjectDocument(
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow().vocabulary(), project("mine"), FILE);

    private static Project project(String id) {
        return new Project(
                id,
                "",
                "crw",
                List.of(),
                List.of(),
                List.of(new PlanBuilder("p").start("a").build()));
    }

    private void name(String name) {
        document.apply(new VertexEdit.NameVertex("p", "a", name));
    }

    @Test
    void theAuthorsProjectComesBackWithItsHistoryAndItsFile() {
        name("Go");
        Project mine = document.project();

        document.lend(project("copy"));
        name("Shown");
        document.undo();
        document.undo();
        assertThat(document.project().id()).isEqualTo("copy");
        assertThat(document.file()).isEmpty();
        assertThat(document.isLent()).isTrue();
        document.giveBack();

        assertThat(document.isLent()).isFalse();
        assertThat(document.project()).isSameAs(mine);
        assertThat(document.file()).isEqualTo(FILE);
        assertThat(document.isModified()).isTrue();
        document.undo();
        assertThat(document.project()).isEqualTo(project("mine"));
    }

    @Test
    void whatTheAuthorWorksOnIsKnownWhileSomethingElseIsShown() {
        name("Go");
        Project mine = document.project();

        document.lend(project("copy"));
        document.lend(project("another copy"));

        assertThat(document.work()).isEqualTo(new ProjectDocument.Work(mine, FILE, true));
        document.giveBack();
        assertThat(document.project()).isSameAs(mine);
    }

    @Test
    void listenersHearThatAnotherProjectIsShown() {
        List<String> heard = new ArrayList<>();
        document.addListener(
                change -> heard.add(change.cause() + " " + change.after().id()));

        document.lend(project("copy"));
        document.giveBack();
        document.giveBack();

        assertThat(heard).containsExactly("OPENED copy", "OPENED mine");
    }
}
