package org.sami.session.server;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.lang.ref.Reference;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;

/** A front of tests, on the JDK's WebSocket. */
final class TestFront implements WebSocket.Listener {
    private static final ObjectMapper JSON = new ObjectMapper();

    private final BlockingQueue<String> received = new LinkedBlockingQueue<>();
    private final StringBuilder part = new StringBuilder();
    private final WebSocket socket;

    TestFront(HttpClient client, String url) {
        URI at = URI.create(url.replaceFirst("^http", "ws") + "session");
        try {
            socket = client.newWebSocketBuilder().buildAsync(at, this).join();
        } finally {
            // one that is collected before its connection is open leaves that unanswered
            Reference.reachabilityFence(client);
        }
    }

    TestFront(SessionServer server) {
        this(HttpClient.newHttpClient(), server.url());
    }

    static TestFront loggedIn(SessionServer server, String name, String key) throws Exception {
        TestFront front = new TestFront(server);
        front.send("{\"t\":\"hello\",\"v\":1,\"name\":\"" + name + "\",\"key\":\"" + key + "\"}");
        front.until(message -> message.path("t").asText().equals("welcome"));
        return front;
    }

    void send(String text) {
        socket.sendText(text, true).join();
    }

    /** Sends it; whether it went out. */
    boolean trySend(String text) {
        try {
            send(text);
            return true;
        } catch (CompletionException closed) {
            return false;
        }
    }

    /** Waits for a message. */
    JsonNode until(Predicate<JsonNode> which) throws Exception {
        while (true) {
            String text = received.poll(15, TimeUnit.MINUTES);
            if (text == null) {
                throw new IllegalStateException("nothing came for 15 minutes");
            }
            JsonNode message = JSON.readTree(text);
            if (which.test(message)) {
                return message;
            }
            if (message.path("t").asText().equals("closed")) {
                throw new IllegalStateException("the server has closed it: " + text);
            }
        }
    }

    /** Waits for the reply to a command. */
    JsonNode reply(long id) throws Exception {
        return until(message -> message.path("id").asLong(-1) == id
                && !message.path("t").asText().equals("rows"));
    }

    /** Waits until the server closes it; gives the code. */
    int closed() throws Exception {
        return until(message -> message.path("t").asText().equals("closed"))
                .path("code")
                .asInt();
    }

    /** Waits for rows with a decision; gives the first. */
    JsonNode decision() throws Exception {
        return until(message -> message.path("set").has("decisions")
                        && !message.path("set").path("decisions").isEmpty())
                .path("set")
                .path("decisions")
                .get(0);
    }

    @Override
    public CompletionStage<?> onText(WebSocket from, CharSequence data, boolean last) {
        part.append(data);
        if (last) {
            received.add(part.toString());
            part.setLength(0);
        }
        from.request(1);
        return null;
    }

    @Override
    public CompletionStage<?> onClose(WebSocket from, int code, String reason) {
        received.add(JSON.createObjectNode()
                .put("t", "closed")
                .put("code", code)
                .put("reason", reason)
                .toString());
        return null;
    }

    @Override
    public void onError(WebSocket from, Throwable fault) {
        received.add("{\"t\":\"closed\",\"code\":" + (fault instanceof IOException ? 1006 : 0) + "}");
    }
}
