package org.sami.crw.sim.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Function;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.link.security.OpenLinks;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.OwnPort;
import org.sami.crw.proxy.file.BoatFileLink;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.file.LogFetch;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.boat.BoatSettings;
import org.sami.session.api.LinkedBoat;
import org.sami.spn.value.GeoPoint;

/** The fetching of logs as a window shows it, of boats on real ports. */
@Timeout(900)
class LogFetchTest {
    private final ExecutorService front = Executors.newSingleThreadExecutor();
    private final LogFetch fetch =
            new LogFetch(front, boat -> new BoatFileLink(boat.address().toSocketAddress(), new OpenLinks()), () -> {});

    @TempDir
    private Path folder;

    @AfterEach
    void end() {
        ask(one -> {
            one.cancel();
            return true;
        });
        front.shutdown();
    }

    private <T> T ask(Function<LogFetch, T> question) {
        return java.util.concurrent.CompletableFuture.supplyAsync(() -> question.apply(fetch), front)
                .join();
    }

    private BoatOnTcp boat(String name, int port, boolean logs) throws IOException {
        BoatSettings settings = BoatSettings.of(
                name, new InetSocketAddress(InetAddress.getLoopbackAddress(), port), GeoPoint.of(45.4, 10.9), 1);
        return new BoatOnTcp(
                logs ? settings.loggingTo(folder.resolve("boats")) : settings,
                SteadyClock.ofThisMachine(),
                TcpServerListener.NONE);
    }

    private static LinkedBoat link(String name, InetSocketAddress at) {
        return new LinkedBoat(name, address(at));
    }

    private static BoatAddress address(InetSocketAddress at) {
        return new BoatAddress(at.getHostString(), at.getPort());
    }

    private void begin(Set<BoatAddress> chosen, Path into) {
        ask(one -> {
            one.begin(chosen, into);
            return true;
        });
    }

    private void offer(LinkedBoat... links) {
        ask(one -> {
            one.offer(List.of(links));
            return true;
        });
    }

    private String states() {
        return ask(one -> one.rows().stream()
                .map(row -> row.boat() + " " + row.state())
                .toList()
                .toString());
    }

    private void untilEnded() {
        Await.until("it has ended", () -> !ask(LogFetch::isRunning));
    }

    @Test
    void chosenBoatsGiveTheirLogsAndTheOthersStay() throws Exception {
        try (BoatOnTcp anna = boat("anna", 0, true);
                BoatOnTcp bert = boat("bert", 0, false);
                BoatOnTcp carl = boat("carl", 0, true)) {
            offer(link("carl", carl.address()), link("anna", anna.address()), link("bert", bert.address()));
            assertThat(states()).isEqualTo("[anna IDLE, bert IDLE, carl IDLE]");
            begin(Set.of(address(anna.address()), address(bert.address())), folder.resolve("base"));
            untilEnded();

            assertThat(states()).isEqualTo("[anna HERE, bert NO_LOG, carl IDLE]");
            assertThat(folder.resolve("base/anna/anna.log")).hasSameBinaryContentAs(folder.resolve("boats/anna.log"));
            assertThat(folder.resolve("base/carl")).doesNotExist();
            assertThat(ask(LogFetch::said))
                    .isEqualTo("Logs of anna are in " + folder.resolve("base") + "; bert keeps no log");
            assertThat(ask(LogFetch::isBad)).isFalse();
        }
    }

    @Test
    void boatThatDoesNotAnswerIsTriedUntilItDoes() throws Exception {
        InetSocketAddress at = new InetSocketAddress(InetAddress.getLoopbackAddress(), OwnPort.draw());
        offer(link("anna", at));
        begin(Set.of(address(at)), folder.resolve("base"));
        Await.until("it is said that anna does not answer", () -> states().equals("[anna NO_ANSWER]"));
        try (BoatOnTcp again = boat("anna", at.getPort(), true)) {
            untilEnded();
            assertThat(states()).isEqualTo("[anna HERE]");
        }
    }

    @Test
    void cancelledFetchSaysWhatDidNotCome() throws Exception {
        InetSocketAddress at = new InetSocketAddress(InetAddress.getLoopbackAddress(), OwnPort.draw());
        offer(link("anna", at));
        begin(Set.of(address(at)), folder.resolve("base"));
        Await.until("it is said that anna does not answer", () -> states().equals("[anna NO_ANSWER]"));
        offer(); // its link is gone: its row stays while it is fetched
        ask(one -> {
            one.cancel();
            return true;
        });
        untilEnded();

        assertThat(states()).isEqualTo("[anna CANCELLED]");
        assertThat(ask(LogFetch::said)).startsWith("not all of anna, as it was cancelled");
        assertThat(ask(LogFetch::isBad)).isTrue();
    }

    @Test
    void fileInPlaceOfTheFolderAndNoBoatAreRefusedInWords() throws Exception {
        Path file = Files.writeString(folder.resolve("file"), "");
        begin(Set.of(), file);
        assertThat(ask(LogFetch::said)).isEqualTo("Choose a boat first");
        try (BoatOnTcp anna = boat("anna", 0, true)) {
            offer(link("anna", anna.address()));
            begin(Set.of(address(anna.address())), file);
            assertThat(ask(LogFetch::said)).isEqualTo(file + " is no folder: choose another");
            assertThat(ask(LogFetch::isRunning)).isFalse();
            assertThat(states()).isEqualTo("[anna IDLE]");
        }
    }
}
