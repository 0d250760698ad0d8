package org.sami.session.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import java.net.InetAddress;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.WebSocket;
import java.nio.file.Path;
import java.security.cert.X509Certificate;
import java.util.Optional;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLEngine;
import javax.net.ssl.TrustManager;
import javax.net.ssl.X509ExtendedTrustManager;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.security.Identity;
import org.sami.crw.operator.OperatorLogEntry;
import org.sami.crw.session.Session;
import org.sami.session.person.People;
import org.sami.session.person.PeopleFile;
import org.sami.session.person.PersonRole;
import org.sami.session.server.testing.ServedSession;

/** Several people at one session, over real sockets on loopback. */
class SessionServerTest {
    private static final String START = "{\"t\":\"start\",\"id\":1,\"plan\":\"station-keep\"}";
    private static final int RUBBISH = 10_000;
    private static final int READ_AT_MOST = 20; // of one connection: that many messages which are none end it
    private static final String PING = "{\"t\":\"ping\",\"id\":9}";

    @TempDir
    private Path folder;

    private ServedSession served;
    private Session session;
    private PeopleFile people;
    private SessionServer server;

    @BeforeEach
    void serve() throws Exception {
        served = ServedSession.ofPlan("station-keep", folder)
                .with("anna", PersonRole.OPERATOR)
                .with("ben", PersonRole.OPERATOR)
                .with("otto", PersonRole.OBSERVER);
        session = served.session();
        people = served.people();
        server = served.serve();
        served.begin();
    }

    private TestFront login(String name) throws Exception {
        return TestFront.loggedIn(server, name, "key of " + name);
    }

    @AfterEach
    void end() throws Exception {
        served.close();
    }

    private static String answer(long id, JsonNode decision) {
        StringBuilder fields = new StringBuilder();
        for (JsonNode field : decision.path("fields")) {
            JsonNode value = field.path("value");
            String given = !value.isMissingNode()
                    ? value.toString()
                    : field.path("type").asText().equals("point") ? "{\"lat\":45.7,\"lon\":10.72}" : "1";
            fields.append(fields.length() == 0 ? "" : ",")
                    .append('"')
                    .append(field.path("key").asText())
                    .append("\":")
                    .append(given);
        }
        return "{\"t\":\"answer\",\"id\":" + id + ",\"decision\":" + decision.path("id") + ",\"answer\":{\"fields\":{"
                + fields + "}}}";
    }

    @Test
    void firstAnswerCountsAndTheSecondLearnsWhoGaveIt() throws Exception {
        TestFront anna = login("anna");
        TestFront ben = login("ben");
        anna.send(START);
        JsonNode asked = ben.decision();
        JsonNode seen = anna.decision();

        assertThat(asked.path("yours").asBoolean()).isTrue();
        assertThat(asked.path("form").asText()).isEqualTo("fields");
        anna.send(answer(2, seen));
        assertThat(anna.reply(2).path("t").asText()).isEqualTo("done");
        ben.send(answer(3, asked));
        JsonNode second = ben.reply(3);

        assertThat(second.path("t").asText()).isEqualTo("refused");
        assertThat(second.path("text").asText()).startsWith("anna has answered decision ");
        session.models().shown().toCompletableFuture().get();
        assertThat(session.models().log().snapshot())
                .extracting(OperatorLogEntry::text)
                .anyMatch(text -> text.startsWith("anna answered ["))
                .anyMatch(text -> text.startsWith("anna started station-keep as mission "));
    }

    @Test
    void missionGoesOnWithTheAnswerOfABrowser() throws Exception {
        TestFront anna = login("anna");
        anna.send(START);
        JsonNode asked = anna.decision();
        anna.send(answer(2, asked));

        JsonNode gone = anna.until(message -> message.path("gone")
                .path("decisions")
                .toString()
                .contains(asked.path("id").toString()));
        assertThat(gone.path("full").asBoolean()).isFalse();
    }

    @Test
    void observerIsRefusedByNameAndMayStopTheFleet() throws Exception {
        TestFront otto = login("otto");
        otto.send(START);
        JsonNode refused = otto.reply(1);

        assertThat(refused.path("text").asText())
                .isEqualTo("The role observer of otto does not have the right 'start'");
        otto.send("{\"t\":\"stopFleet\",\"id\":2}");
        JsonNode stopped = otto.until(message ->
                message.path("set").path("fleet").path(0).path("stopped").asBoolean());
        assertThat(stopped.path("set").path("fleet").path(0).path("words").asText())
                .startsWith("FLEET STOP");
    }

    @Test
    void wrongKeyIsLetInNowhere() throws Exception {
        TestFront nobody = new TestFront(server);
        nobody.send("{\"t\":\"hello\",\"v\":1,\"name\":\"anna\",\"key\":\"guessed\"}");

        assertThat(nobody.reply(0).path("text").asText()).isEqualTo("no such name and key");
        assertThat(nobody.closed()).isEqualTo(1008);
        TestFront early = new TestFront(server);
        early.send(START);
        assertThat(early.reply(1).path("t").asText()).isEqualTo("refused");
        assertThat(early.closed()).isEqualTo(1008);
    }

    @Test
    void removedPersonIsOutAndOthersGoOn() throws Exception {
        TestFront anna = login("anna");
        TestFront ben = login("ben");

        new PeopleFile(people.file()).remove("anna"); // as another process does

        assertThat(anna.closed()).isEqualTo(1008);
        ben.send(PING);
        assertThat(ben.reply(9).path("t").asText()).isEqualTo("done");
    }

    @Test
    void tenThousandMessagesOfRubbishEndTheirOwnConnectionsOnly() throws Exception {
        TestFront anna = login("anna");
        anna.send(START);
        JsonNode asked = anna.decision();
        HttpClient client = HttpClient.newHttpClient();
        int sent = 0;
        for (int connection = 0; sent < RUBBISH; connection++) {
            TestFront rubbish = new TestFront(client, server.url());
            if (connection % 20 == 0) { // a login takes a tenth of a second
                rubbish.send("{\"t\":\"hello\",\"v\":1,\"name\":\"otto\",\"key\":\"key of otto\"}");
            }
            int ofThis = 0;
            while (ofThis < READ_AT_MOST && rubbish.trySend(rubbish(sent))) {
                sent++;
                ofThis++;
            }
            assertThat(rubbish.closed()).isIn(1006, 1008);
        }
        anna.send(answer(2, asked));

        assertThat(anna.reply(2).path("t").asText()).isEqualTo("done");
    }

    private static String rubbish(int number) {
        return switch (number % 6) {
            case 0 -> "not JSON " + number;
            case 1 -> "[]";
            case 2 -> "{\"t\":\"answer\",\"id\":" + number + ",\"password\":1}";
            case 3 -> "{\"t\":\"x".repeat(200);
            case 4 -> "{\"t\":\"start\",\"id\":" + number + ",\"plan\":{\"a\":[null,1e999]}}";
            default -> "{\"a\":".repeat(5000);
        };
    }

    @Test
    void tooLargeMessageEndsItsOwnConnectionOnly() throws Exception {
        TestFront anna = login("anna");
        TestFront ben = login("ben");
        ben.trySend("{\"t\":\"note\",\"id\":1,\"text\":\"" + "x".repeat(70_000) + "\"}");

        assertThat(ben.closed()).isIn(1006, 1009);
        anna.send(PING);
        assertThat(anna.reply(9).path("t").asText()).isEqualTo("done");
    }

    @Test
    void pageIsKeptToItsOwnOrigin() throws Exception {
        HttpClient client = HttpClient.newHttpClient();
        HttpResponse<String> page = client.send(
                HttpRequest.newBuilder(URI.create(server.url())).build(), HttpResponse.BodyHandlers.ofString());
        HttpResponse<String> outside = client.send(
                HttpRequest.newBuilder(URI.create(server.url() + "../people")).build(),
                HttpResponse.BodyHandlers.ofString());

        assertThat(page.statusCode()).isEqualTo(200);
        assertThat(page.headers().firstValue("Content-Security-Policy").orElseThrow())
                .startsWith("default-src 'none'; script-src 'self'; style-src 'self';")
                .doesNotContain("unsafe", "http:", "https:", "ws:", "wss:", "*");
        assertThat(outside.statusCode()).isIn(400, 404);
        assertThatThrownBy(() -> client.newWebSocketBuilder()
                        .header("Origin", "http://elsewhere.example")
                        .buildAsync(
                                URI.create(server.url().replace("http", "ws") + "session"), new WebSocket.Listener() {})
                        .join())
                .hasMessageContaining("WebSocketHandshakeException");
    }

    @Test
    void protectedServerShowsTheKeyOfTheBase() throws Exception {
        SSLContext trusting = SSLContext.getInstance("TLS");
        trusting.init(null, new TrustManager[] {new AnyCertificate()}, null);
        HttpClient client = HttpClient.newBuilder().sslContext(trusting).build();
        ServerAddress address =
                new ServerAddress(InetAddress.getLoopbackAddress(), 0, Optional.of(Identity.generate()));
        try (SessionServer secured = SessionServer.start(session, people, address)) {
            TestFront anna = new TestFront(client, secured.url().replace("127.0.0.1", "localhost"));
            anna.send("{\"t\":\"hello\",\"v\":1,\"name\":\"anna\",\"key\":\"key of anna\"}");

            assertThat(secured.url()).startsWith("https://");
            assertThat(anna.until(message -> message.path("t").asText().equals("welcome"))
                            .path("role")
                            .asText())
                    .isEqualTo("operator");
        }
    }

    @Test
    void whereThePortIsTakenItIsSaidHowToGiveAnotherOne() {
        ServerAddress same = ServerAddress.onThisMachine(server.listensAt().getPort());

        assertThatThrownBy(() -> SessionServer.start(session, People.ofThisMachine(), same))
                .hasMessage("port " + same.port()
                        + " is taken by another program, such as another session; --port gives another one");
    }

    @Test
    void nothingButLoopbackIsServedPlainlyOrWithoutPeople() throws Exception {
        InetAddress all = InetAddress.getByName("0.0.0.0");

        assertThatThrownBy(() -> new ServerAddress(all, 0, Optional.empty())).hasMessageContaining("loopback");
        ServerAddress open = new ServerAddress(all, 0, Optional.of(Identity.generate()));
        assertThatThrownBy(() -> SessionServer.start(session, People.ofThisMachine(), open))
                .hasMessageContaining("loopback");
    }

    /** Trusts whoever answers, host names too. */
    private static final class AnyCertificate extends X509ExtendedTrustManager {
        @Override
        public void checkClientTrusted(X509Certificate[] chain, String type) {}

        @Override
        public void checkServerTrusted(X509Certificate[] chain, String type) {}

        @Override
        public void checkClientTrusted(X509Certificate[] chain, String type, Socket socket) {}

        @Override
        public void checkServerTrusted(X509Certificate[] chain, String type, Socket socket) {}

        @Override
        public void checkClientTrusted(X509Certificate[] chain, String type, SSLEngine engine) {}

        @Override
        public void checkServerTrusted(X509Certificate[] chain, String type, SSLEngine engine) {}

        @Override
        public X509Certificate[] getAcceptedIssuers() {
            return new X509Certificate[0];
        }
    }
}
