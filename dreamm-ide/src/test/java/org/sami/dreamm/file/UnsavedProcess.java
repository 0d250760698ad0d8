package org.sami.dreamm.file;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.spn.edit.ProjectEdit;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.ui.EventThread;

/** A process that opens a project, edits it, saves nothing, and waits until it is killed. */
final class UnsavedProcess {
    private UnsavedProcess() {}

    /** Arguments: the shared folder of unsaved work, the project's file. */
    public static void main(String[] args) throws Exception {
        DomainLibrary domain =
                DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
        Path path = Path.of(args[1]);
        RecoveryFolder recovery = RecoveryFolder.take(Path.of(args[0]), domain.vocabulary());
        EventThread.get(() -> {
            ProjectDocument document = new ProjectDocument(
                    domain.vocabulary(),
                    new ProjectReader(domain.vocabulary()).read(path).orThrow(),
                    Optional.of(path));
            keep(document, recovery);
            return document.apply(new ProjectEdit.NameProject("not saved"));
        });
        new CountDownLatch(1).await();
    }

    private static void keep(ProjectDocument document, RecoveryFolder recovery) {
        try {
            new ProjectFile(document).save(document.file().orElseThrow());
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
        new Autosave(document, recovery, System.err::println).keep();
    }
}
