package org.sami.session.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionSetup;
import org.sami.session.map.TestTiles;
import org.sami.session.map.TileFile;
import org.sami.session.person.PeopleFile;
import org.sami.spn.json.DomainLibrary;

/** The background map as browsers fetch it. */
class BackgroundMapTest {
    @TempDir
    private Path folder;

    @Test
    void tilesAreServedByLevelColumnAndRow() throws Exception {
        try (TileFile map = TileFile.open(TestTiles.write(folder.resolve("lake.mbtiles"), "png", 3, 5, 1));
                Session session = session();
                SessionServer server = start(session, Optional.of(map))) {
            HttpResponse<byte[]> about = get(server, "tiles/map.json");
            HttpResponse<byte[]> tile = get(server, "tiles/3/5/1");

            assertThat(new String(about.body(), StandardCharsets.UTF_8))
                    .isEqualTo("{\"attribution\":\"made by hand\",\"coarsest\":3,\"finest\":3}");
            assertThat(tile.body()).isEqualTo(TestTiles.PICTURE);
            assertThat(tile.headers().firstValue("Content-Type")).contains("image/png");
            assertThat(get(server, "tiles/3/5/2").statusCode()).isEqualTo(404);
            assertThat(get(server, "tiles/99/9999999/9999999").statusCode()).isEqualTo(404);
            assertThat(get(server, "page.js").statusCode()).isEqualTo(200);
        }
    }

    @Test
    void withoutAMapThereIsNothingToDescribe() throws Exception {
        try (Session session = session();
                SessionServer server = start(session, Optional.empty())) {
            assertThat(get(server, "tiles/map.json").statusCode()).isEqualTo(204);
            assertThat(get(server, "tiles/3/5/1").statusCode()).isEqualTo(404);
        }
    }

    private static Session session() throws Exception {
        DomainLibrary library =
                DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
        return Session.open(SessionSetup.of(
                library.vocabulary(), library.projectOf("station-keep").orElseThrow()));
    }

    private SessionServer start(Session session, Optional<TileFile> map) throws Exception {
        return SessionServer.start(
                session,
                new PeopleFile(folder.resolve("people")),
                ServerAddress.onThisMachine(0),
                map,
                SessionBases.NONE);
    }

    private static HttpResponse<byte[]> get(SessionServer server, String path) throws Exception {
        URI page = URI.create(server.url());
        return HttpClient.newHttpClient()
                .send(
                        HttpRequest.newBuilder(page.resolve("/" + path)).build(),
                        HttpResponse.BodyHandlers.ofByteArray());
    }
}
