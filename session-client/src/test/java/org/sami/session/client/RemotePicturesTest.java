package org.sami.session.client;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalTime;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.stream.Collectors;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.security.Identity;
import org.sami.boat.server.testing.Await;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.operator.picture.BoatPicture;
import org.sami.crw.operator.picture.PanoramaPictures;
import org.sami.crw.proxy.command.Panorama;
import org.sami.crw.session.Session;
import org.sami.session.client.testing.FrontNotices;
import org.sami.session.person.PersonRole;
import org.sami.session.record.PictureRows;
import org.sami.session.record.SessionPictures;
import org.sami.session.server.ServerAddress;
import org.sami.session.server.SessionBases;
import org.sami.session.server.SessionServer;
import org.sami.session.server.testing.ServedSession;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** Pictures of boats in a front elsewhere, over HTTPS on loopback. */
class RemotePicturesTest {
    private static final int LARGE = 3_000_000;
    private static final byte[] PICTURE = {(byte) 0xff, (byte) 0xd8, 1, 2, 3, 4};

    @TempDir
    private Path folder;

    private final ExecutorService front = Executors.newSingleThreadExecutor();
    private ServedSession served;
    private Session session;
    private SessionServer server;
    private SessionPictures kept;

    @BeforeEach
    void serve() throws Exception {
        served = ServedSession.ofPlan("station-keep", folder).with("otto", PersonRole.OBSERVER);
        session = served.session();
        server = served.serve(
                new ServerAddress(InetAddress.getLoopbackAddress(), 0, Optional.of(Identity.generate())),
                SessionBases.NONE);
        served.begin();
        kept = SessionPictures.in(folder.resolve("kept"));
    }

    @AfterEach
    void end() throws Exception {
        served.close();
        front.shutdown();
    }

    private static byte[] large() {
        byte[] picture = new byte[LARGE];
        new SplittableRandom(7).nextBytes(picture);
        System.arraycopy(PICTURE, 0, picture, 0, PICTURE.length);
        return picture;
    }

    /** The boat anna has taken pictures, of which the first has come, and the last will not. */
    private void take(String panorama) throws IOException {
        take(panorama, PICTURE);
    }

    private void take(String panorama, byte[] picture) throws IOException {
        Path file = kept.place(SessionPictures.path("anna", panorama, "a.jpg"));
        Files.write(file, picture);
        Panorama command = new Panorama(panorama, 1, Ids.NONE, 2, Priority.MEDIUM);
        for (FleetEvent event : List.of(
                new FleetEvent.PanoramaTaken("anna", command, 2, GeoPoint.of(45.4, 10.9), List.of("a.jpg", "b.jpg")),
                new FleetEvent.PictureFetched("anna", panorama, "a.jpg", file),
                new FleetEvent.PictureMissed("anna", panorama, "b.jpg", "anna has deleted it"))) {
            session.models().pictures().restore(event, 1000);
            new PictureRows(kept).write(session.telemetry(), 1000, event);
        }
    }

    private RemoteSession open() throws Exception {
        return open(server.listensAt().getPort());
    }

    private RemoteSession open(int port) throws Exception {
        return RemoteSession.open(
                List.of(SessionAddress.parse("wss://127.0.0.1:" + port)),
                new Login("otto", "key of otto"),
                new ServerTrust(new KnownServers(folder.resolve("servers")), (address, print) -> true),
                front,
                new FrontNotices(),
                () -> LocalTime.NOON);
    }

    private static List<String> states(RemoteSession remote) {
        return remote.models().pictures().snapshot().stream()
                .map(PanoramaPictures::words)
                .collect(Collectors.toList());
    }

    @Test
    void picturesOfBeforeAndAfterTheConnectionComeByThemselves() throws Exception {
        take("p1");
        Path here;
        try (RemoteSession remote = open()) {
            remote.fetchPictures();
            Await.until(
                    "the first has come",
                    () -> states(remote).equals(List.of("anna: 1 of 2 pictures, 1 will not come")));
            BoatPicture first =
                    remote.models().pictures().snapshot().get(0).pictures().get(0);
            here = first.file().orElseThrow();
            assertThat(here).hasBinaryContent(PICTURE);
            assertThat(here.startsWith(folder)).as("a copy").isFalse();

            take("p2");

            Await.until(
                    "the second has come",
                    () -> states(remote)
                            .equals(List.of(
                                    "anna: 1 of 2 pictures, 1 will not come",
                                    "anna: 1 of 2 pictures, 1 will not come")));
        }
        Await.until("nothing of it stays here", () -> !Files.exists(here));
    }

    @Test
    void pictureThatStandsStillInTheMiddleComesAfterTheNextLogin() throws Exception {
        take("p1", large());
        try (CuttableRelay relay = new CuttableRelay(new InetSocketAddress(
                        InetAddress.getLoopbackAddress(), server.listensAt().getPort()));
                RemoteSession remote = open(relay.port())) {
            relay.stallAfter(LARGE / 2);
            remote.fetchPictures();
            Await.until("the picture stands still", relay::hasStalled);

            relay.cut();

            Await.until("it has come", () -> states(remote).equals(List.of("anna: 1 of 2 pictures, 1 will not come")));
        }
    }

    @Test
    void nothingIsFetchedWhereNobodyWantsToSeePictures() throws Exception {
        take("p1");
        try (RemoteSession remote = open()) {
            remote.caughtUp().toCompletableFuture().get();

            assertThat(states(remote)).containsExactly("anna: 0 of 2 pictures, 1 not here yet, 1 will not come");
        }
    }

    @Test
    void pictureThatTheBaseHasLostIsSaidToBeMissing() throws Exception {
        take("p1");
        Files.delete(kept.file(SessionPictures.path("anna", "p1", "a.jpg")));

        try (RemoteSession remote = open()) {
            remote.fetchPictures();
            Await.until("it is known", () -> states(remote).equals(List.of("anna: 0 of 2 pictures, 2 will not come")));
            assertThat(remote.models()
                            .pictures()
                            .snapshot()
                            .get(0)
                            .pictures()
                            .get(0)
                            .words())
                    .isEqualTo("the base does not give this picture");
        }
    }
}
