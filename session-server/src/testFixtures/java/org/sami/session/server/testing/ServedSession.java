package org.sami.session.server.testing;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionSetup;
import org.sami.crw.session.archive.SessionJournal;
import org.sami.session.person.PeopleFile;
import org.sami.session.person.Person;
import org.sami.session.person.PersonKey;
import org.sami.session.person.PersonRole;
import org.sami.session.server.ServerAddress;
import org.sami.session.server.SessionBases;
import org.sami.session.server.SessionServer;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;

/** A session without a journal whose people log in by keys, on servers on loopback. For one thread; servers and session are closed with it. */
public final class ServedSession implements AutoCloseable {
    private static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    private final Session session;
    private final PeopleFile people;
    private final List<SessionServer> servers = new ArrayList<>();

    private ServedSession(Project project, Path folder) throws IOException {
        JournalHeader header = JournalHeader.of(
                new ProjectWriter(LIBRARY.vocabulary()).text(project),
                LIBRARY.files().texts(),
                Map.of());
        session = Session.open(SessionSetup.of(LIBRARY.vocabulary(), project).with(SessionJournal.none(header)));
        people = new PeopleFile(folder.resolve("people"));
    }

    /**
     * A session of a plan of the library, with nobody and without a server; it has not begun.
     *
     * @param folder of the list of people
     */
    public static ServedSession ofPlan(String plan, Path folder) throws IOException {
        return new ServedSession(LIBRARY.projectOf(plan).orElseThrow(), folder);
    }

    /** The same with a project, as a file has it. */
    public static ServedSession ofProject(String json, Path folder) throws IOException {
        return new ServedSession(
                new ProjectReader(LIBRARY.vocabulary()).read(json).orThrow(), folder);
    }

    /** Lists a person, whose key is {@code key of NAME}. */
    public ServedSession with(String name, PersonRole role) throws IOException {
        people.add(new Person(name, role, List.of(), PersonKey.hash("key of " + name)));
        return this;
    }

    /** Serves it in plain text on a free port. */
    public SessionServer serve() throws IOException {
        return serve(ServerAddress.onThisMachine(0), SessionBases.NONE);
    }

    /** Serves it at an address, on which nothing else listens. */
    public SessionServer serve(ServerAddress at, SessionBases bases) throws IOException {
        SessionServer server = SessionServer.start(session, people, at, Optional.empty(), bases);
        servers.add(server);
        return server;
    }

    /** Begins the session; servers before it see all of it. */
    public ServedSession begin() throws IOException {
        session.begin();
        return this;
    }

    /** The session. */
    public Session session() {
        return session;
    }

    /** The people who may log in. */
    public PeopleFile people() {
        return people;
    }

    @Override
    public void close() throws Exception {
        for (int last = servers.size() - 1; last >= 0; last--) {
            servers.get(last).close();
        }
        session.close();
    }
}
