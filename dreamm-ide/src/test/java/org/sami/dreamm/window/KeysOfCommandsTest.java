package org.sami.dreamm.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.export.ExportCommands;
import org.sami.dreamm.file.FileCommands;
import org.sami.dreamm.file.RecentProjects;
import org.sami.dreamm.file.RecoveryFolder;
import org.sami.dreamm.profile.Profile;
import org.sami.spn.json.DomainLibrary;
import org.sami.ui.command.Command;
import org.sami.ui.window.ViewCommands;
import org.sami.ui.window.WindowSettings;

class KeysOfCommandsTest {
    private static final DomainLibrary BOATS =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    /** Between the modes R goes to and fro; notes are laid once. */
    private static final String WITHOUT = "net-mode-nominal|net-mode-recovery|net-lay-notes";

    @TempDir
    private Path data;

    @Test
    void whatAnAuthorDoesHasAKeyOfItsOwn() throws Exception {
        DreammContext context = new DreammContext(
                BOATS,
                new ProjectDocument(BOATS.vocabulary(), BOATS.projectOf("clv").orElseThrow(), Optional.empty()),
                Profile.ALL);
        WindowSettings settings = new WindowSettings(data.resolve("window.properties"));
        FileCommands files = new FileCommands(
                context,
                null,
                new RecentProjects(settings),
                RecoveryFolder.take(data.resolve("recovery"), BOATS.vocabulary()));
        EditCommands.addTo(context);
        ExportCommands.addTo(context);
        RunParts run = new RunParts(context);
        try {
            assertThat(new DreammPanels(context, run).all()).isNotEmpty();
            new ViewCommands(context.commands(), null, settings);

            assertThat(context.commands().all().stream()
                            .filter(command -> command.keyText().isEmpty())
                            .map(Command::id))
                    .allMatch(id -> id.matches(WITHOUT));
        } finally {
            files.close();
            run.close();
            context.close();
        }
    }
}
