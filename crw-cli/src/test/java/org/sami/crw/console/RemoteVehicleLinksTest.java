package org.sami.crw.console;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.LocalTime;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.crw.proxy.gateway.LinkStatus;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionSetup;
import org.sami.crw.session.archive.SessionJournal;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.session.client.KnownServers;
import org.sami.session.client.Login;
import org.sami.session.client.RemoteSession;
import org.sami.session.client.ServerTrust;
import org.sami.session.client.SessionAddress;
import org.sami.session.client.testing.FrontNotices;
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

/** The links on which a vehicle of another maker is reached, as somebody on another machine sees them. */
@Tag("long")
@Timeout(900)
class RemoteVehicleLinksTest {
    private static final double WAIT_S = 300;

    @TempDir
    private Path folder;

    @Test
    void linksOfAVehicleAreSeenFromElsewhereAsThemselves() throws Exception {
        DomainLibrary library =
                DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
        Project project = library.projectOf("clv").orElseThrow();
        JournalHeader header = JournalHeader.of(
                new ProjectWriter(library.vocabulary()).text(project),
                library.files().texts(),
                Map.of());
        PeopleFile people = new PeopleFile(folder.resolve("people"));
        people.add(new Person("olga", PersonRole.OBSERVER, List.of(), PersonKey.hash("key of olga")));
        ExecutorService front = Executors.newSingleThreadExecutor();
        try (SmallBoat vehicle = new SmallBoat(7, 45.7, 10.72, 1);
                Session session = Session.open(
                        SessionSetup.of(library.vocabulary(), project).with(SessionJournal.none(header)));
                SessionServer server = SessionServer.start(session, people, ServerAddress.onThisMachine(0))) {
            session.fleet().connect(BoatAddress.parse(vehicle.address() + "/7"));
            session.fleet().connect(BoatAddress.parse(vehicle.secondAddress() + "/7"));
            session.begin();
            try (RemoteSession olga = RemoteSession.open(
                    List.of(SessionAddress.parse(
                            "ws://127.0.0.1:" + server.listensAt().getPort())),
                    new Login("olga", "key of olga"),
                    new ServerTrust(new KnownServers(folder.resolve("servers")), (address, print) -> false),
                    front,
                    new FrontNotices(),
                    () -> LocalTime.NOON)) {
                Await.until("both links are seen", WAIT_S, () -> links(olga).size() == 2);

                assertThat(links(olga))
                        .extracting(LinkStatus::link)
                        .containsExactlyInAnyOrder(vehicle.address(), vehicle.secondAddress());
                assertThat(links(olga).get(0).words())
                        .startsWith("in use, ")
                        .contains("% lost")
                        .endsWith(" bytes/s asked");
                assertThat(links(olga).get(1).words()).startsWith("ready, ").endsWith("% lost");
            }
        } finally {
            front.shutdown();
        }
    }

    private static List<LinkStatus> links(RemoteSession from) {
        return from.fleet().linkStatuses("mav7").toCompletableFuture().join();
    }
}
