package org.sami.session.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.net.InetAddress;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.WebSocket;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.security.Identity;
import org.sami.session.person.People;
import org.sami.session.person.PeopleFile;
import org.sami.session.person.Person;
import org.sami.session.person.PersonKey;
import org.sami.session.person.PersonRole;

/** What a base answers that waits for another's session: real sockets on loopback. */
class StandbyServerTest {
    private static final SessionBases BASES = SessionBases.parse(List.of("ws://127.0.0.1:4711"));

    @TempDir
    private Path folder;

    private PeopleFile people;
    private StandbyServer standby;

    @BeforeEach
    void waitForTheSession() throws IOException {
        people = new PeopleFile(folder.resolve("people"));
        people.add(new Person("anna", PersonRole.OPERATOR, List.of(), PersonKey.hash("key of anna")));
        standby = StandbyServer.start(people, ServerAddress.onThisMachine(0), Optional.empty(), BASES);
    }

    @AfterEach
    void end() {
        standby.close();
    }

    private TestFront front() {
        return new TestFront(HttpClient.newHttpClient(), standby.url());
    }

    @Test
    void frontIsToldWhoHoldsTheSessionAndWhereTheBasesAre() throws Exception {
        standby.say("the session is held by laptop-1");

        TestFront anna = front();
        JsonNode told = anna.until(message -> true);

        assertThat(told.toString())
                .isEqualTo("{\"t\":\"standby\",\"text\":\"the session is held by laptop-1\","
                        + "\"bases\":[{\"id\":\"ws://127.0.0.1:4711\"}]}");
        assertThat(anna.closed()).isEqualTo(1013);
    }

    @Test
    void keysAreNotLookedAt() throws Exception {
        TestFront anna = front();
        anna.trySend("{\"t\":\"hello\",\"v\":1,\"name\":\"anna\",\"key\":\"key of anna\"}");

        assertThat(anna.until(message -> true).path("t").asText()).isEqualTo("standby");
        assertThat(anna.closed()).isEqualTo(1013);
    }

    @Test
    void pageIsThereAndMayConnectToTheOtherBases() throws Exception {
        HttpResponse<String> page = HttpClient.newHttpClient()
                .send(HttpRequest.newBuilder(URI.create(standby.url())).build(), HttpResponse.BodyHandlers.ofString());

        assertThat(page.statusCode()).isEqualTo(200);
        assertThat(page.headers().firstValue("Content-Security-Policy").orElseThrow())
                .contains("connect-src 'self' ws://127.0.0.1:4711 http://127.0.0.1:4711;");
    }

    @Test
    void pagesOfTheBasesMayOpenTheLinkAndThoseOfOthersMayNot() {
        open("http://127.0.0.1:4711").abort();

        assertThatThrownBy(() -> open("http://127.0.0.1:4712")).hasMessageContaining("WebSocketHandshakeException");
        assertThatThrownBy(() -> open("http://127.0.0.1:4711.elsewhere.example"))
                .hasMessageContaining("WebSocketHandshakeException");
    }

    private WebSocket open(String origin) {
        return HttpClient.newHttpClient()
                .newWebSocketBuilder()
                .header("Origin", origin)
                .buildAsync(URI.create(standby.url().replace("http", "ws") + "session"), new WebSocket.Listener() {})
                .join();
    }

    @Test
    void withoutPeopleItIsForThisMachineOnly() throws Exception {
        ServerAddress open = new ServerAddress(InetAddress.getByName("0.0.0.0"), 0, Optional.of(Identity.generate()));

        assertThatThrownBy(() -> StandbyServer.start(People.ofThisMachine(), open, Optional.empty(), BASES))
                .hasMessage("without people and keys a session is served on a loopback address only");
    }
}
