package org.sami.dreamm.file;

import java.io.IOException;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import javax.swing.Timer;
import org.sami.dreamm.document.DocumentChange;
import org.sami.dreamm.document.DocumentListener;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.ui.EventThread;

/**
 * Keeps unsaved work in a {@link RecoveryFolder}, half a second after an edit at most, off the event thread. What is saved, and what is
 * closed, is kept no longer.
 */
public final class Autosave implements AutoCloseable {
    private static final int DELAY_MS = 500;
    private static final int END_S = 10;

    private final ProjectDocument document;
    private final RecoveryFolder folder;
    private final Consumer<String> failed;
    private final ExecutorService writer = Executors.newSingleThreadExecutor(work -> {
        Thread thread = new Thread(work, "autosave");
        thread.setDaemon(true);
        return thread;
    });
    private final Timer timer = new Timer(DELAY_MS, e -> keep());

    /**
     * Begins to keep a document.
     *
     * @param failed receives on the event thread, in one sentence, why something could not be kept
     */
    public Autosave(ProjectDocument document, RecoveryFolder folder, Consumer<String> failed) {
        this.document = Objects.requireNonNull(document, "document");
        this.folder = Objects.requireNonNull(folder, "folder");
        this.failed = Objects.requireNonNull(failed, "failed");
        timer.setRepeats(false);
        document.addListener(new DocumentListener() {
            @Override
            public void changed(DocumentChange change) {
                // its state changes as well
            }

            @Override
            public void stateChanged() {
                timer.start(); // where it runs already it is not begun again, so that typing does not put it off
            }
        });
    }

    /** Keeps what is unsaved now, at once, off the event thread. */
    public void keep() {
        keep(Optional.empty());
    }

    /**
     * Keeps what is unsaved now, at once, off the event thread.
     *
     * @param restored where it was kept before: forgotten there once it is kept here
     */
    void keep(Optional<UnsavedWork> restored) {
        ProjectDocument.Work work = document.work();
        writer.execute(() -> {
            try {
                if (work.modified()) {
                    folder.keep(work.project(), work.file());
                } else {
                    folder.clear();
                }
                if (restored.isPresent()) {
                    RecoveryFolder.forget(restored.get());
                }
            } catch (IOException full) {
                EventThread.later(() -> failed.accept(
                        "unsaved changes cannot be kept for the case that DREAMM is killed: " + full.getMessage()));
            }
        });
    }

    /** Ends it, as the author has saved, or given up, what there was: nothing is kept. */
    @Override
    public void close() throws IOException {
        timer.stop();
        writer.shutdown();
        try {
            if (!writer.awaitTermination(END_S, TimeUnit.SECONDS)) {
                throw new IOException("unsaved changes are still being written");
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        folder.clear();
        folder.close();
    }
}
