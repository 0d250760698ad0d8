package org.sami.dreamm.file;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import javax.swing.Timer;
import org.sami.dreamm.context.AuthorQuestion;
import org.sami.dreamm.context.DreammContext;

/** Looks every two seconds, off the event thread, whether another program has changed the project's files, and asks what is to be shown. */
final class DiskWatch implements AutoCloseable {
    private static final String ID = "changed-on-disk";
    private static final int PERIOD_MS = 2000;

    private final DreammContext context;
    private final ProjectFile file;
    private final Timer timer = new Timer(PERIOD_MS, e -> look());
    private boolean looking;
    /** The other program's version about which the author was asked, so that it is asked about once. */
    private Optional<DiskVersion> asked = Optional.empty();

    DiskWatch(DreammContext context, ProjectFile file) {
        this.context = Objects.requireNonNull(context, "context");
        this.file = Objects.requireNonNull(file, "file");
        timer.start();
    }

    private void look() {
        Optional<Path> path = context.document().file();
        Optional<DiskVersion> seen = file.seen();
        if (looking || path.isEmpty() || seen.isEmpty()) {
            return;
        }
        looking = true;
        context.background().run("Looking at " + path.get(), () -> now(path.get()), now -> {
            looking = false;
            // what was saved or opened meanwhile is not another program's
            if (now.isPresent()
                    && context.document().file().equals(path)
                    && file.seen().equals(seen)) {
                compare(path.get(), seen.get(), now.get());
            }
        });
    }

    /** What is there now; nothing where it cannot be read, as while it is being written: the next look may. */
    private static Optional<DiskVersion> now(Path path) {
        try {
            return Optional.of(DiskVersion.of(path));
        } catch (IOException unreadable) {
            return Optional.empty();
        }
    }

    private void compare(Path path, DiskVersion seen, DiskVersion now) {
        boolean isNew = !asked.equals(Optional.of(now));
        asked = Optional.of(now);
        if (now.equals(seen)) {
            context.questions().withdraw(ID);
        } else if (isNew) {
            changed(path, now);
        }
    }

    private void changed(Path path, DiskVersion now) {
        if (!now.isThere()) {
            context.notices().refused(path + " is no longer on disk; Save writes it again");
            return;
        }
        String mine = context.document().isModified() ? " Your changes can be had back by undo." : "";
        context.questions()
                .askAside(new AuthorQuestion(
                        ID,
                        path.getFileName() + " was changed by another program." + mine,
                        List.of(
                                new AuthorQuestion.Choice("disk-load", "Load it", () -> load(path)),
                                new AuthorQuestion.Choice("disk-keep", "Keep what is here", () -> {})),
                        () -> {}));
    }

    private void load(Path path) {
        try {
            file.take(file.read(path));
            context.notices().show(path.getFileName() + " is loaded as it is on disk");
        } catch (IOException unfit) {
            context.notices().refused(String.valueOf(unfit.getMessage()));
        }
    }

    @Override
    public void close() {
        timer.stop();
    }
}
