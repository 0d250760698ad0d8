package org.sami.crw.console;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.link.security.Identity;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.cli.CommandResult;
import org.sami.crw.operator.OperatorLogEntry;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionSetup;
import org.sami.crw.session.archive.SessionJournal;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.boat.BoatSettings;
import org.sami.session.person.PeopleFile;
import org.sami.session.person.Person;
import org.sami.session.person.PersonKey;
import org.sami.session.person.PersonRole;
import org.sami.session.server.ServerAddress;
import org.sami.session.server.SessionServer;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;
import org.sami.spn.value.GeoPoint;

/** {@code crw session --session} as its user has it: a real server on loopback, a real boat, a person's key. */
class RemoteConsoleTest {
    private static final GeoPoint PIER = GeoPoint.of(45.4, 10.9);
    private static final String NEAR = "45.40003,10.90003"; // 4 m from the pier

    @TempDir
    private Path folder;

    private BoatOnTcp boat;
    private Session session;
    private SessionServer server;

    @BeforeEach
    void serve() throws Exception {
        boat = new BoatOnTcp(
                BoatSettings.of("bo", new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), PIER, 1),
                new SteadyClock(ProcessClock::ms),
                TcpServerListener.NONE);
        DomainLibrary library =
                DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
        Project project = library.projectOf("clv").orElseThrow();
        JournalHeader header = JournalHeader.of(
                new ProjectWriter(library.vocabulary()).text(project),
                library.files().texts(),
                Map.of());
        session = Session.open(SessionSetup.of(library.vocabulary(), project).with(SessionJournal.none(header)));
        PeopleFile people = new PeopleFile(folder.resolve("people"));
        for (PersonRole role : List.of(PersonRole.OPERATOR, PersonRole.OBSERVER)) {
            String key = "key of the " + role.word();
            people.add(new Person(role.word(), role, List.of(), PersonKey.hash(key)));
            Files.writeString(folder.resolve(role.word()), key + "\n");
        }
        server = SessionServer.start(session, people, ServerAddress.onThisMachine(0));
        session.fleet().connect(BoatAddress.parse("127.0.0.1:" + boat.address().getPort()));
        session.begin();
    }

    @AfterEach
    void end() throws Exception {
        server.close();
        session.close();
        boat.close();
    }

    private CommandResult console(String person, String... commands) throws IOException {
        Path script = Files.write(Files.createTempFile(folder, "script", ".txt"), List.of(commands));
        List<String> arguments = new ArrayList<>(List.of("session", "--script", script.toString()));
        arguments.addAll(
                List.of("--session", "ws://127.0.0.1:" + server.listensAt().getPort()));
        arguments.addAll(
                List.of("--person", person, "--key-file", folder.resolve(person).toString()));
        return CommandResult.crw(arguments.toArray(new String[0]));
    }

    @Test
    void missionIsStartedAnsweredAndFollowedToItsEnd() throws Exception {
        CommandResult ran = console(
                "operator",
                "wait boats 1",
                "start clv",
                "wait decision",
                "answer all",
                "wait decision",
                "answer " + NEAR,
                "wait decision",
                "answer 1",
                "wait ended",
                "missions",
                "why bo",
                "note seen from elsewhere at 45.4,10.9",
                "log",
                "quit");

        assertThat(ran.err()).isEmpty();
        assertThat(ran.exitCode()).isZero();
        assertThat(ran.out())
                .contains("bo is linked", "mission 1 of clv has begun", "[1] is answered", "[3] is answered")
                .contains("mission 1 of clv: ended at ")
                .contains("operator answered [1] Select boats", "seen from elsewhere")
                .doesNotContain("key of the operator");
        session.models().shown().toCompletableFuture().get();
        assertThat(session.models().log().snapshot())
                .extracting(OperatorLogEntry::text)
                .contains("operator started clv as mission 1", "operator notes: seen from elsewhere");
    }

    @Test
    void whatIsWishedWithoutALinkIsSaidChangedAndSetFromElsewhere() throws Exception {
        CommandResult ran = console(
                "operator", "wait boats 1", "lost-link", "lost-link return", "lost-link set", "lost-link", "quit");

        assertThat(ran.err()).isEmpty();
        assertThat(ran.exitCode()).isZero();
        assertThat(ran.out())
                .containsSubsequence(
                        "nothing is wished",
                        "bo holds its place",
                        "wished: without a link a boat returns to its home",
                        "bo holds its place: set it, this session wishes that it returns to its home",
                        "bo is set, as it has confirmed",
                        "bo returns to its home");
        assertThat(session.fleet().lostLinkWish()).contains(LostLinkAction.RETURN);
        assertThat(console("observer", "lost-link drift").out())
                .contains("crw: The role observer of observer does not have the right 'setup'");
    }

    @Test
    void whatTheRoleOrThePlaceDoesNotAllowIsSaidInOneLine() throws Exception {
        CommandResult ran = console("observer", "wait boats 1", "start clv", "fence none", "on-fault", "stop all");

        assertThat(ran.exitCode()).isEqualTo(6);
        assertThat(ran.out())
                .contains("crw: The role observer of observer does not have the right 'start'")
                .contains("crw: not from here: the fence is set on the machine of the session")
                .contains("crw: not from here: what boats do on a fault is set on the machine of the session")
                .contains("FLEET STOP: bo");
    }

    @Test
    void certificateThatNobodyComparedIsNamedWithTheOptionThatTakesIt() throws Exception {
        ServerAddress secured =
                new ServerAddress(InetAddress.getLoopbackAddress(), 0, Optional.of(Identity.generate()));
        PeopleFile people = new PeopleFile(folder.resolve("people"));
        try (SessionServer second = SessionServer.start(session, people, secured)) {
            String authority = "127.0.0.1:" + second.listensAt().getPort();
            String print = second.certificate().orElseThrow();
            String[] command = {
                "session",
                "--session",
                "wss://" + authority,
                "--person",
                "operator",
                "--key-file",
                folder.resolve("operator").toString()
            };

            CommandResult first = CommandResult.crw(command);
            CommandResult other =
                    CommandResult.crw(Stream.concat(Stream.of(command), Stream.of("--certificate", "00:11"))
                            .toArray(String[]::new));

            assertThat(first.err())
                    .contains(authority + " is connected to for the first time", "--certificate " + print);
            assertThat(other.err()).contains("--certificate: that of " + authority + " has another SHA-256, " + print);
            assertThat(List.of(first.exitCode(), other.exitCode())).containsOnly(2);
        }
    }

    @Test
    void optionsOfASessionOfThisProcessAreRefused() {
        CommandResult both = CommandResult.crw("session", "clv", "--session", "ws://127.0.0.1:1", "--person", "anna");
        CommandResult nobody = CommandResult.crw("session", "--session", "ws://127.0.0.1:1");
        CommandResult plain = CommandResult.crw("session", "--session", "ws://10.0.0.5:8080", "--person", "anna");
        CommandResult alone = CommandResult.crw("session", "--person", "anna");

        assertThat(both.err()).contains("FILE|PLAN is for a session of this process");
        assertThat(nobody.err()).contains("--session needs --person NAME");
        assertThat(plain.err()).contains("keys are sent by TLS only: wss://10.0.0.5:8080");
        assertThat(alone.err()).contains("go with --session");
        assertThat(List.of(both.exitCode(), nobody.exitCode(), plain.exitCode(), alone.exitCode()))
                .containsOnly(2);
    }
}
