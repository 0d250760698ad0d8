package org.sami.dreamm.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.dreamm.context.AuthorQuestion;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.profile.Profile;
import org.sami.spn.edit.ProjectEdit;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;
import org.sami.ui.window.WindowSettings;

/** Nothing that an author typed, drew or has on disk is lost by a command. Without a window, with real files. */
class FileCommandsTest {
    private static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final long PATIENCE_S = 60;

    @TempDir
    private Path folder;

    private Path path;
    private DreammContext context;
    private RecoveryFolder recovery;
    private FileCommands files;

    @BeforeEach
    void open() throws Exception {
        path = folder.resolve("clv.json");
        write(DOMAIN.projectOf("clv").orElseThrow(), path);
        recovery = RecoveryFolder.take(folder.resolve("recovery"), DOMAIN.vocabulary());
        onEventThread(() -> {
            context = new DreammContext(
                    DOMAIN,
                    new ProjectDocument(
                            DOMAIN.vocabulary(), DOMAIN.projectOf("clv").orElseThrow(), Optional.of(path)),
                    Profile.ALL);
            files = new FileCommands(
                    context,
                    new JPanel(),
                    new RecentProjects(new WindowSettings(folder.resolve("settings"))),
                    recovery);
        });
    }

    @AfterEach
    void close() throws Exception {
        onEventThread(() -> {
            files.close();
            context.close();
        });
    }

    private static void write(Project project, Path to) throws IOException {
        new ProjectWriter(DOMAIN.vocabulary()).write(project, to);
    }

    private static void onEventThread(Runnable work) throws Exception {
        SwingUtilities.invokeAndWait(work);
    }

    private void edit() {
        context.apply(new ProjectEdit.ClonePlan("clv", "copy", "Copy"));
    }

    private void save() {
        context.commands().get("project-save").run();
    }

    private String asked() {
        return context.questions().current().map(AuthorQuestion::id).orElse("");
    }

    /** Is counted down once a question of that id is asked. */
    private CountDownLatch question(String id) throws Exception {
        CountDownLatch asked = new CountDownLatch(1);
        onEventThread(() -> context.questions().addListener(() -> {
            if (asked().equals(id)) {
                asked.countDown();
            }
        }));
        return asked;
    }

    private static void await(CountDownLatch latch) throws InterruptedException {
        assertThat(latch.await(PATIENCE_S, TimeUnit.SECONDS)).isTrue();
    }

    private String onDisk() {
        try {
            return Files.readString(path);
        } catch (IOException fault) {
            throw new UncheckedIOException(fault);
        }
    }

    @Test
    void whatIsTypedIsSavedToo() throws Exception {
        onEventThread(() -> {
            context.typed().add(this::edit);
            save();

            assertThat(context.document().isModified()).isFalse();
            assertThat(onDisk()).contains("\"copy\"");
        });
    }

    @Test
    void whatIsTypedCountsAsAChangeBeforeTheProjectIsLeft() throws Exception {
        onEventThread(() -> {
            boolean[] left = new boolean[1];
            context.typed().add(this::edit);
            files.guard(() -> left[0] = true);

            assertThat(asked()).isEqualTo("unsaved-changes");
            assertThat(left[0]).isFalse();
        });
    }

    @Test
    void aProjectThatOpensSlowlyAsksAboutWhatWasEditedMeanwhile() throws Exception {
        Path other = folder.resolve("other.json");
        write(DOMAIN.projectOf("station-keep").orElseThrow(), other);
        CountDownLatch slow = new CountDownLatch(1);
        CountDownLatch unsaved = question("unsaved-changes");
        onEventThread(() -> {
            context.background().run("Waiting", () -> waitFor(slow), done -> {});
            files.open(other);
            edit();
        });
        slow.countDown();
        await(unsaved);

        onEventThread(() -> {
            assertThat(context.document().file()).contains(path);
            assertThat(context.document().isModified()).isTrue();
        });
    }

    private static boolean waitFor(CountDownLatch latch) {
        try {
            return latch.await(PATIENCE_S, TimeUnit.SECONDS);
        } catch (InterruptedException ended) {
            Thread.currentThread().interrupt();
            return false;
        }
    }

    @Test
    void aChangeByAnotherProgramIsAskedAboutWithoutTheFocusAndIsNotWrittenOver() throws Exception {
        CountDownLatch changed = question("changed-on-disk");
        Files.writeString(path, onDisk().replace("Select boats", "Choose boats"));
        await(changed);

        onEventThread(() -> {
            assertThat(context.questions()
                            .takesFocus(context.questions().current().orElseThrow()))
                    .isFalse();
            edit();
            save();

            assertThat(context.questions().current().orElseThrow().choices())
                    .extracting(AuthorQuestion.Choice::id)
                    .contains("disk-over");
            assertThat(onDisk()).contains("Choose boats").doesNotContain("\"copy\"");
        });
    }

    @Test
    void aFileThatWasDeletedIsWrittenAgain() throws Exception {
        Files.delete(path);
        onEventThread(() -> {
            save();
            assertThat(path).exists();
        });
    }
}
