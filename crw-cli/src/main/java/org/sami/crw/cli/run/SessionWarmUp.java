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
import org.sami.session.person.Person;
import org.sami.session.server.ServerAddress;
import org.sami.session.server.SessionServer;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalHeader;

/**
 * Opens a session of the same plans in advance, without a journal and without a boat, and closes it again. This loads the classes that a session needs, so that a take-over does not wait for
 * them. The session does not begin, and nobody can log in to it.
 */
final class SessionWarmUp implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(SessionWarmUp.class.getName());
    private static final People NOBODY = new People() {
        @Override
        public Optional<Person> login(String name, String key) {
            return Optional.empty();
        }

        @Override
        public Optional<Person> present(Person earlier) {
            return Optional.empty();
        }

        @Override
        public Optional<String> fault() {
            return Optional.empty();
        }

        @Override
        public boolean needKeys() {
            return true;
        }
    };

    private final JournalAddress journal;
    private final Consumer<String> lines;
    private volatile boolean closed;

    /**
     * One that has not begun.
     *
     * @param journal that of the session
     * @param lines that it is over, for people
     */
    SessionWarmUp(JournalAddress journal, Consumer<String> lines) {
        this.journal = journal;
        this.lines = lines;
    }

    /** Begins in the background. */
    void begin() {
        Thread thread = new Thread(this::run, "warm-up of a session");
        thread.setDaemon(true);
        thread.start();
    }

    private void run() {
        try {
            Optional<JournalHeader> header = journal.header();
            if (header.isPresent()) {
                open(header.get());
                if (!closed) {
                    lines.accept("ready");
                }
            }
        } catch (IOException | RuntimeException fault) {
            LOG.log(
                    System.Logger.Level.DEBUG,
                    "the warm-up of a session failed",
                    fault); // a take-over meets the same, or it does not matter
        }
    }

    private static void open(JournalHeader header) throws IOException {
        SessionSetup setup = SessionSetup.resumed(SessionJournal.none(header))
                .with(SessionRuntime.RealTime.ofThisProcess())
                .with(FaultPolicy.ALONE);
        ServerAddress address = new ServerAddress(InetAddress.getLoopbackAddress(), 0, Optional.empty());
        try (Session session = Session.open(setup);
                SessionServer server = SessionServer.start(session, NOBODY, address)) {
            LOG.log(System.Logger.Level.DEBUG, "warmed up at {0}", server.url());
        }
    }

    /** The session is taken over, or nobody waits for it any more: nothing more is said. */
    @Override
    public void close() {
        closed = true;
    }
}
