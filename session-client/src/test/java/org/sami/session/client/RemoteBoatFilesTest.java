package org.sami.session.client;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.KeptFile;
import org.sami.crw.proxy.file.FileFetchException;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.session.api.LinkedBoat;

/** Which answers of a base end a fetch of logs, and after which it is tried again. */
class RemoteBoatFilesTest {
    @TempDir
    private Path folder;

    private HttpServer base;
    private volatile Optional<TicketedBase> holder = Optional.empty(); // changed on the thread of the base
    private RemoteBoatFiles files;
    private int status = 200;
    private String body = "";
    private boolean saysLength = true;
    private Runnable asked = () -> {};

    @BeforeEach
    void serve() throws Exception {
        base = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
        base.createContext("/", exchange -> {
            asked.run();
            byte[] content = body.getBytes(StandardCharsets.UTF_8);
            exchange.getResponseHeaders().set("Content-Type", "text/plain; charset=utf-8");
            exchange.sendResponseHeaders(status, saysLength ? content.length : 0);
            exchange.getResponseBody().write(content);
            exchange.close();
        });
        base.start();
        holder = Optional.of(TicketedBase.of(
                SessionAddress.parse("ws://127.0.0.1:" + base.getAddress().getPort()),
                new ServerTrust(new KnownServers(folder.resolve("servers")), (address, print) -> true),
                "a ticket"));
        files = new RemoteBoatFiles(new LinkedBoat("anna", BoatAddress.parse("127.0.0.1:11411")), () -> holder);
    }

    @AfterEach
    void end() {
        files.close();
        base.stop(0);
    }

    private void answers(int code, String text) {
        status = code;
        body = text;
    }

    @Test
    void listOfABaseIsRead() throws Exception {
        answers(200, "{\"files\":[{\"name\":\"anna.log\",\"bytes\":3,\"sha256\":\"" + "0f".repeat(32) + "\"}]}");

        assertThat(files.list(KeptFile.LOG)).extracting(KeptFile::name).containsExactly("anna.log");
    }

    @Test
    void listWhoseLengthIsNotSaidIsRefused() {
        answers(200, "{\"files\":[]}");
        saysLength = false;

        assertThatThrownBy(() -> files.list(KeptFile.LOG))
                .isInstanceOf(FileFetchException.class)
                .hasMessageContaining("it is not read");
    }

    @Test
    void listThatIsTooLongIsRefused() {
        answers(200, "{\"files\":[]}" + " ".repeat(16 << 20));

        assertThatThrownBy(() -> files.list(KeptFile.LOG))
                .isInstanceOf(FileFetchException.class)
                .hasMessageContaining("it is not read");
    }

    @Test
    void answerWithoutAListIsRefused() {
        answers(200, "{}");

        assertThatThrownBy(() -> files.list(KeptFile.LOG))
                .isInstanceOf(FileFetchException.class)
                .hasMessage("the base answers with no list of logs");
    }

    private void assertTriedAgain() {
        assertThatThrownBy(() -> files.list(KeptFile.LOG))
                .isInstanceOf(IOException.class)
                .isNotInstanceOf(FileFetchException.class);
    }

    private void assertFinal() {
        assertThatThrownBy(() -> files.list(KeptFile.LOG)).isInstanceOf(FileFetchException.class);
    }

    @Test
    void baseThatHasNoLinkToTheBoatYetIsAskedAgain() {
        answers(404, "the base has no link to a boat 'anna'");

        assertTriedAgain();
    }

    @Test
    void pageOfAStandbyIsNoAnswerOnceTheLoginThereHasEnded() {
        answers(404, "Nothing is here\n");
        asked = () -> holder = Optional.empty();

        assertTriedAgain();
    }

    @Test
    void pageOfAStandbyIsNoAnswerOnceThereIsAnotherLogin() {
        answers(404, "Nothing is here\n");
        TicketedBase renewed = holder.orElseThrow().with("another ticket");
        asked = () -> holder = Optional.of(renewed);

        assertTriedAgain();
    }

    @Test
    void baseOfBeforeThatKnowsNoLogsEndsTheFetch() {
        answers(404, "Nothing is here\n");

        assertFinal();
    }

    @Test
    void boatThatRefusesEndsTheFetch() {
        answers(502, "anna does not know this base");

        assertFinal();
    }
}
