package org.sami.crw.sim.boat;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.KeptFile;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.link.security.OpenLinks;
import org.sami.boat.server.log.LogFiles;
import org.sami.boat.server.log.LogHistory;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.testing.Await;
import org.sami.crw.proxy.file.BoatFileFetch;
import org.sami.crw.proxy.file.FileNews;
import org.sami.spn.value.GeoPoint;

/** A base fetches the log of a boat that goes on to new files meanwhile, over real sockets and cut links. */
@Tag("long")
@Timeout(900)
class RotatedLogFetchTest {
    @TempDir
    private Path folder;

    private BoatOnTcp boat(long logBytes) throws IOException {
        InetSocketAddress anyPort = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
        return new BoatOnTcp(
                BoatSettings.of("anna", anyPort, new GeoPoint(45.4, 10.9, 0), 1)
                        .loggingTo(folder.resolve("boat"), logBytes),
                SteadyClock.ofThisMachine(),
                TcpServerListener.NONE);
    }

    private LogFiles onBoat() {
        return new LogFiles(folder.resolve("boat/anna.log"));
    }

    private Path base() {
        return folder.resolve("base");
    }

    private static List<String> ids(LogFiles files) throws IOException {
        List<String> ids = new ArrayList<>();
        assertThat(LogHistory.read(files, entry -> ids.add(entry.command().commandId())))
                .as("damaged lines")
                .isZero();
        return ids;
    }

    private void assertSame() throws IOException {
        for (Path file : onBoat().byNumber().values()) {
            assertThat(base().resolve("anna").resolve(file.getFileName())).hasSameBinaryContentAs(file);
        }
    }

    @Test
    void filesThatComeIntoBeingDuringAFetchCutByTheNetworkAreWholeAtTheBase() throws Exception {
        try (BoatOnTcp boat = boat(1 << 20);
                CuttingRelay relay =
                        new CuttingRelay(boat.address(), number -> number < 8 ? 60_000 : Integer.MAX_VALUE);
                PlainCommander commander = new PlainCommander(boat.address())) {
            commander.upload(100);
            AtomicInteger pieces = new AtomicInteger();
            CompletableFuture<Void> first = new CompletableFuture<>();
            BoatFileFetch fetch = new BoatFileFetch(relay.address(), new OpenLinks(), (id, name, here, bytes) -> {
                if (pieces.incrementAndGet() == 5) {
                    first.complete(null);
                }
            });
            CompletableFuture<BoatFileFetch.Result> during = CompletableFuture.supplyAsync(() -> {
                try {
                    return fetch.fetchAll(KeptFile.LOG, base());
                } catch (IOException e) {
                    throw new AssertionError(e);
                }
            });
            first.get(60, TimeUnit.SECONDS);
            int before = onBoat().byNumber().lastKey();
            commander.upload(100);
            for (int more = 0; more < 40 && onBoat().byNumber().lastKey() == before; more++) {
                commander.upload(5); // the next file is begun once it is on the disk
            }
            assertThat(onBoat().byNumber().lastKey()).as("newest file").isGreaterThan(before);
            assertThat(during.get(120, TimeUnit.SECONDS).refused()).isEmpty();
            assertThat(relay.connections()).as("links").isGreaterThan(1);

            BoatFileFetch.Result after =
                    new BoatFileFetch(boat.address(), new OpenLinks(), FileNews.NONE).fetchAll(KeptFile.LOG, base());
            assertThat(after.refused()).isEmpty();
            assertSame();
            assertThat(ids(new LogFiles(base().resolve("anna/anna.log")))).isEqualTo(commander.ids());
        }
    }

    @Test
    void fileThatTheBoatRemovesDuringAFetchIsNamedAndTheOthersCome() throws Exception {
        try (BoatOnTcp boat = boat(1 << 20);
                PlainCommander commander = new PlainCommander(boat.address())) {
            commander.upload(100);
            Path oldest = onBoat().byNumber().get(0);
            BoatFileFetch fetch = new BoatFileFetch(boat.address(), new OpenLinks(), (id, name, here, bytes) -> {
                if (name.equals("anna.log")) {
                    uploadUntilGone(commander, oldest);
                }
            });
            BoatFileFetch.Result result = fetch.fetchAll(KeptFile.LOG, base());

            assertThat(result.refused()).anySatisfy(why -> assertThat(why).contains("keeps no file of that name"));
            new BoatFileFetch(boat.address(), new OpenLinks(), FileNews.NONE).fetchAll(KeptFile.LOG, base());
            assertSame();
        }
    }

    private static void uploadUntilGone(PlainCommander commander, Path file) {
        Await.until("the boat has removed " + file.getFileName(), () -> {
            try {
                if (Files.exists(file)) {
                    commander.upload(20);
                }
                return !Files.exists(file);
            } catch (IOException | LinkException e) {
                throw new AssertionError(e);
            }
        });
    }

    @Test
    void restartedBoatGoesOnInItsNewestFileAndTheBaseWithIt() throws Exception {
        List<String> ids;
        try (BoatOnTcp boat = boat(1 << 20);
                PlainCommander commander = new PlainCommander(boat.address())) {
            commander.upload(120);
            ids = commander.ids();
            new BoatFileFetch(boat.address(), new OpenLinks(), FileNews.NONE).fetchAll(KeptFile.LOG, base());
        }
        int newest = onBoat().byNumber().lastKey();
        try (BoatOnTcp boat = boat(1 << 20)) {
            assertThat(boat.restored()).isEqualTo(ids.size());
            assertThat(onBoat().byNumber().lastKey()).isEqualTo(newest);
            BoatFileFetch.Result result =
                    new BoatFileFetch(boat.address(), new OpenLinks(), FileNews.NONE).fetchAll(KeptFile.LOG, base());
            assertThat(result.bytes()).as("only the line of the new start").isLessThan(100);
            assertSame();
        }
    }

    @Test
    void commandsGoOnDuringAFetch() throws Exception {
        try (BoatOnTcp boat = boat(8 << 20);
                PlainCommander commander = new PlainCommander(boat.address())) {
            commander.upload(400);
            double alone = commander.p99Ms(100);
            AtomicInteger pieces = new AtomicInteger();
            BoatFileFetch fetch = new BoatFileFetch(
                    boat.address(), new OpenLinks(), (id, name, here, bytes) -> pieces.incrementAndGet());
            CompletableFuture<Void> ended = CompletableFuture.runAsync(() -> {
                try {
                    fetch.fetchAll(KeptFile.LOG, base());
                } catch (IOException e) {
                    throw new AssertionError(e);
                }
            });
            int from = commander.acknowledgedAfterNanos.size();
            Await.until("pieces come", () -> pieces.get() > 3);
            while (!ended.isDone()) {
                commander.upload(1);
            }
            int commands = commander.acknowledgedAfterNanos.size() - from;
            System.out.printf(
                    "p99 of an acknowledgement: %.1f ms alone, %.1f ms with a fetch (%d commands, %d pieces)%n",
                    alone, commander.p99Ms(from), commands, pieces.get());
            assertThat(commands)
                    .as("commands while %s pieces came", pieces.get())
                    .isPositive();
        }
    }
}
