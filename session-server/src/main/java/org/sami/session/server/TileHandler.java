package org.sami.session.server;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.http.HttpMethod;
import org.eclipse.jetty.http.HttpStatus;
import org.eclipse.jetty.server.Handler;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.util.Callback;
import org.sami.session.map.TileFile;

/**
 * Serves the background map: {@code /tiles/map.json} says what there is (without a map 204, no content), {@code /tiles/Z/X/Y} is a tile. Passes on all other
 * requests.
 */
final class TileHandler extends Handler.Wrapper {
    private static final Pattern TILE = Pattern.compile("/tiles/(\\d{1,2})/(\\d{1,7})/(\\d{1,7})");

    private final Optional<TileFile> map;

    private final SessionBases bases;

    /**
     * Serves a map, if there is one.
     *
     * @param bases whose pages may read it too, after a take-over
     */
    TileHandler(Optional<TileFile> map, SessionBases bases, Handler others) {
        super(others);
        this.bases = bases;
        this.map = map;
    }

    @Override
    public boolean handle(Request request, Response response, Callback callback) throws Exception {
        String path = Request.getPathInContext(request);
        Matcher tile = TILE.matcher(path);
        boolean describes = path.equals("/tiles/map.json");
        if (!HttpMethod.GET.is(request.getMethod()) || !(describes || tile.matches())) {
            return super.handle(request, response, callback);
        }
        response.getHeaders()
                .put("X-Content-Type-Options", "nosniff")
                .put("Cross-Origin-Resource-Policy", "same-origin");
        bases.letPagesRead(request, response);
        if (map.isEmpty()) {
            response.setStatus(describes ? HttpStatus.NO_CONTENT_204 : HttpStatus.NOT_FOUND_404);
            response.write(true, ByteBuffer.allocate(0), callback);
            return true;
        }
        TileFile.Description about = map.get().description();
        Optional<byte[]> content = describes ? Optional.of(json(about)) : tile(map.get(), tile);
        response.getHeaders()
                .put(HttpHeader.CACHE_CONTROL, "max-age=3600")
                .put(HttpHeader.CONTENT_TYPE, describes ? "application/json" : about.mediaType());
        response.setStatus(content.isPresent() ? HttpStatus.OK_200 : HttpStatus.NOT_FOUND_404);
        response.write(true, ByteBuffer.wrap(content.orElse(new byte[0])), callback);
        return true;
    }

    private static byte[] json(TileFile.Description about) {
        return JsonNodeFactory.instance
                .objectNode()
                .put("attribution", about.attribution())
                .put("coarsest", about.coarsest())
                .put("finest", about.finest())
                .toString()
                .getBytes(StandardCharsets.UTF_8);
    }

    private static Optional<byte[]> tile(TileFile map, Matcher place) throws IOException {
        return map.tile(
                Integer.parseInt(place.group(1)), Integer.parseInt(place.group(2)), Integer.parseInt(place.group(3)));
    }
}
