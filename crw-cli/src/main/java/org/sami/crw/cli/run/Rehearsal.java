package org.sami.crw.cli.run;

import java.io.IOException;
import java.net.InetAddress;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionRuntime;
import org.sami.crw.session.SessionSetup;
import org.sami.crw.session.archive.SessionJournal;
import org.sami.crw.session.fault.FaultPolicy;
import org.sami.session.person.People;
import org.sami.session.server.ServerAddress;
import org.sami.session.server.SessionServer;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalHeader;

/**
 * Opens a session of the same plans beforehand, without a journal and without a boat, and closes it again: what it takes of classes is loaded then, and a take-over need not wait for it. Nothing of it
 * begins, and nobody else reaches it.
 */
final class Rehearsal {
    private Rehearsal() {}

    /**
     * Begins one in the background.
     *
     * @param lines that it is over, for people
     */
    static void begin(JournalAddress journal, Consumer<String> lines) {
        Thread thread = new Thread(
                () -> {
                    run(journal);
                    lines.accept("ready");
                },
                "rehearsal");
        thread.setDaemon(true);
        thread.start();
    }

    private static void run(JournalAddress journal) {
        try {
            Optional<JournalHeader> header = journal.header();
            if (header.isPresent()) {
                run(header.get());
            }
        } catch (IOException | RuntimeException fault) {
            System.getLogger(Rehearsal.class.getName()) // a take-over meets the same, or it does not matter
                    .log(System.Logger.Level.DEBUG, "a rehearsal failed", fault);
        }
    }

    private static void run(JournalHeader header) throws IOException {
        SessionSetup setup = SessionSetup.resumed(SessionJournal.none(header))
                .with(SessionRuntime.RealTime.ofThisProcess())
                .with(FaultPolicy.ALONE);
        ServerAddress address = new ServerAddress(InetAddress.getLoopbackAddress(), 0, Optional.empty());
        try (Session session = Session.open(setup);
                SessionServer server = SessionServer.start(session, People.ofThisMachine(), address)) {
            System.getLogger(Rehearsal.class.getName())
                    .log(System.Logger.Level.DEBUG, "rehearsed at {0}", server.url());
        }
    }
}
