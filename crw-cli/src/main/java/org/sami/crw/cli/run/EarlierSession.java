package org.sami.crw.cli.run;

import java.io.IOException;
import java.nio.file.Files;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.session.archive.SessionJournal;
import org.sami.crw.session.standby.WarmStandby;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalHeader;

/** A session that an earlier process began, or that another base holds still, in its journal. */
final class EarlierSession {
    private final JournalAddress journal;
    private final Opening opening;

    @FunctionalInterface
    private interface Opening {
        SessionJournal open() throws IOException;
    }

    private EarlierSession(JournalAddress journal, Opening opening) {
        this.journal = journal;
        this.opening = opening;
    }

    /** One whose process is over. */
    static EarlierSession at(JournalAddress journal) {
        return new EarlierSession(journal, () -> SessionJournal.open(journal));
    }

    /**
     * One that another base holds: opening it waits for the end of that base's lease, and reads the session meanwhile.
     *
     * @param lines what is waited for, for people
     */
    static EarlierSession ofAnotherBase(JournalAddress journal, Consumer<String> lines) {
        return new EarlierSession(journal, () -> {
            Optional<JournalHeader> header = journal.header();
            if (header.isPresent()) {
                refuseRun(journal, header.get());
            }
            try (SessionWarmUp warmUp = new SessionWarmUp(journal, lines);
                    WarmStandby warm = new WarmStandby(journal, lines, System::nanoTime, warmUp::begin)) {
                return SessionJournal.takeOver(journal, lines, warm::finish);
            }
        });
    }

    /** Whether there is one; a file's name that is taken by anything is no new journal. */
    static boolean isThere(JournalAddress journal) throws IOException {
        return journal.file().isPresent() ? Files.exists(journal.file().get()) : journal.exists();
    }

    /**
     * Opens its journal.
     *
     * @throws UsageFault if it is the journal of a run
     * @throws java.io.InterruptedIOException if the thread is interrupted while this waits
     */
    SessionJournal open() throws IOException {
        SessionJournal opened = opening.open();
        try {
            refuseRun(journal, opened.header().orElseThrow());
        } catch (UsageFault refused) {
            opened.close();
            throw refused;
        }
        return opened;
    }

    private static void refuseRun(JournalAddress journal, JournalHeader header) {
        if (!header.settings().getOrDefault("kind", "").equals("session")) {
            throw new UsageFault(journal + " is the journal of a run; go on with it by: crw resume " + journal);
        }
    }
}
