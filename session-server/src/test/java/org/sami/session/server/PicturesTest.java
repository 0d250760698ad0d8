package org.sami.session.server;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.ByteArrayInputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.crw.session.Session;
import org.sami.session.person.PeopleFile;
import org.sami.session.person.PersonRole;
import org.sami.session.server.testing.ServedSession;

/** Pictures of boats over HTTP on loopback. */
class PicturesTest {
    @TempDir
    private Path folder;

    private ServedSession served;
    private Session session;
    private PeopleFile people;
    private SessionServer server;
    private TestFront otto;
    private String ticket;

    @BeforeEach
    void serve() throws Exception {
        served = ServedSession.ofPlan("station-keep", folder).with("otto", PersonRole.OBSERVER);
        session = served.session();
        people = served.people();
        server = served.serve(ServerAddress.onThisMachine(0), SessionBases.parse(List.of("ws://127.0.0.1:8081")));
        served.begin();
        TakenPanorama.give(session, folder);
        otto = new TestFront(server);
        otto.send("{\"t\":\"hello\",\"v\":1,\"name\":\"otto\",\"key\":\"key of otto\"}");
        ticket = otto.until(message -> message.path("t").asText().equals("welcome"))
                .path("ticket")
                .asText();
    }

    @AfterEach
    void end() throws Exception {
        served.close();
    }

    private HttpResponse<byte[]> get(String query, String shown) throws Exception {
        HttpRequest.Builder request = HttpRequest.newBuilder(URI.create(server.url() + query));
        if (!shown.isEmpty()) {
            request.header("Authorization", "Bearer " + shown);
        }
        return HttpClient.newHttpClient().send(request.build(), HttpResponse.BodyHandlers.ofByteArray());
    }

    @Test
    void onlyPagesOfTheSessionsBasesMayReadPictures() throws Exception {
        for (String method : List.of("GET", "OPTIONS")) {
            assertThat(allowed(method, "http://127.0.0.1:8081")).isEqualTo("http://127.0.0.1:8081");
            assertThat(allowed(method, "http://127.0.0.1:8082")).isEmpty();
        }
    }

    private String allowed(String method, String page) throws Exception {
        try (Socket socket =
                new Socket(InetAddress.getLoopbackAddress(), server.listensAt().getPort())) {
            socket.getOutputStream()
                    .write((method + " /" + TakenPanorama.QUERY + "a.jpg&small=1 HTTP/1.0\r\nOrigin: " + page
                                    + "\r\nAuthorization: Bearer " + ticket + "\r\n\r\n")
                            .getBytes(StandardCharsets.US_ASCII));
            String head = new String(socket.getInputStream().readAllBytes(), StandardCharsets.ISO_8859_1);
            return head.lines()
                    .filter(line -> line.startsWith("Access-Control-Allow-Origin: "))
                    .map(line -> line.substring(line.indexOf(' ') + 1))
                    .findFirst()
                    .orElse("");
        }
    }

    @Test
    void observerLearnsWhichPicturesThereAre() throws Exception {
        JsonNode row = otto.until(message -> message.path("set")
                        .path("pictures")
                        .path(0)
                        .path("pictures")
                        .findValuesAsText("state")
                        .equals(List.of("here", "here", "coming")))
                .path("set")
                .path("pictures")
                .get(0);

        assertThat(row.path("id").asText()).isEqualTo("bella/p1");
        assertThat(row.path("at").asLong()).isEqualTo(1000);
        assertThat(row.path("lat").asDouble()).isEqualTo(45.4);
    }

    @Test
    void smallPictureHasAtMostThirtyKilobytes() throws Exception {
        HttpResponse<byte[]> small = get(TakenPanorama.QUERY + "a.jpg&small=1", ticket);

        assertThat(small.statusCode()).isEqualTo(200);
        assertThat(small.headers().firstValue("Content-Type")).contains("image/jpeg");
        assertThat(small.body()).hasSizeBetween(1000, 30_000);
        assertThat(ImageIO.read(new ByteArrayInputStream(small.body())).getWidth())
                .isEqualTo(320);
    }

    @Test
    void largePictureIsTheFileAndNobodyMayStoreIt() throws Exception {
        HttpResponse<byte[]> large = get(TakenPanorama.QUERY + "a.jpg", ticket);

        assertThat(large.body()).isEqualTo(Files.readAllBytes(folder.resolve("a.jpg")));
        assertThat(large.headers().firstValue("Cache-Control")).contains("no-store");
        assertThat(large.headers().firstValue("Content-Security-Policy").orElse(""))
                .startsWith("default-src 'none'");
        assertThat(large.headers().firstValue("X-Content-Type-Options")).contains("nosniff");
    }

    @Test
    void whatIsNoPictureIsNotServed() throws Exception {
        assertThat(get(TakenPanorama.QUERY + "b.jpg", ticket).statusCode()).isEqualTo(404);
        assertThat(get(TakenPanorama.QUERY + "b.jpg&small=1", ticket).statusCode())
                .isEqualTo(404);
        assertThat(get(TakenPanorama.QUERY + "c.jpg", ticket).statusCode()).isEqualTo(404);
        assertThat(get(TakenPanorama.QUERY + "../people", ticket).statusCode()).isEqualTo(404);
    }

    @Test
    void fourWholePicturesAtMostAreOnTheirWayAtOnce() throws Exception {
        byte[] large = new byte[24 << 20]; // more than a connection holds that nobody reads from
        large[0] = (byte) 0xff;
        large[1] = (byte) 0xd8;
        Files.write(folder.resolve("b.jpg"), large);
        List<Socket> slow = new ArrayList<>();
        try {
            for (int i = 0; i < 4; i++) {
                slow.add(begin("b.jpg"));
            }
            HttpResponse<byte[]> fifth = get(TakenPanorama.QUERY + "a.jpg", ticket);
            assertThat(fifth.statusCode()).isEqualTo(503);
            assertThat(fifth.headers().firstValue("Retry-After")).contains("1");
            assertThat(get(TakenPanorama.QUERY + "a.jpg&small=1", ticket).statusCode())
                    .isEqualTo(200);

            slow.get(0).getInputStream().skipNBytes(large.length); // it goes through
            awaitWhole("a.jpg");
            slow.set(0, begin("b.jpg"));
            assertThat(get(TakenPanorama.QUERY + "a.jpg", ticket).statusCode()).isEqualTo(503);

            slow.get(1).close(); // it fails
            awaitWhole("a.jpg");
        } finally {
            for (Socket one : slow) {
                one.close();
            }
        }
    }

    /** A connection on which a whole picture has begun to come. */
    private Socket begin(String name) throws Exception {
        URI at = URI.create(server.url());
        Socket socket = new Socket(at.getHost(), at.getPort());
        socket.getOutputStream()
                .write(("GET /" + TakenPanorama.QUERY + name + " HTTP/1.1\r\nHost: " + at.getAuthority()
                                + "\r\nAuthorization: Bearer " + ticket + "\r\n\r\n")
                        .getBytes(StandardCharsets.US_ASCII));
        assertThat(new String(socket.getInputStream().readNBytes(12), StandardCharsets.US_ASCII))
                .isEqualTo("HTTP/1.1 200");
        return socket;
    }

    private void awaitWhole(String name) {
        Await.until("a whole picture is served again", () -> {
            try {
                return get(TakenPanorama.QUERY + name, ticket).statusCode() == 200;
            } catch (Exception fault) {
                throw new IllegalStateException(fault);
            }
        });
    }

    @Test
    void nobodyGetsAPictureWithoutATicketOfALoginThatLasts() throws Exception {
        String small = TakenPanorama.QUERY + "a.jpg&small=1";
        assertThat(get(small, "").statusCode()).isEqualTo(401);
        assertThat(get(small, "wrong").statusCode()).isEqualTo(401);
        assertThat(get(small, ticket).statusCode()).isEqualTo(200);

        people.remove("otto");
        otto.closed();

        Await.until("the ticket counts no longer", () -> {
            try {
                return get(small, ticket).statusCode() == 401;
            } catch (Exception fault) {
                throw new IllegalStateException(fault);
            }
        });
    }
}
