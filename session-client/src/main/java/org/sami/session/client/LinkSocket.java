package org.sami.session.client;

import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;

/** One WebSocket to a session's server. Sends texts one after the other. What arrives is given to a listener, on any thread, one after the other. */
final class LinkSocket implements WebSocket.Listener {
    private final Consumer<String> received;
    private final Runnable heard;
    private final Consumer<String> closed;
    private final StringBuilder part = new StringBuilder();
    private CompletableFuture<WebSocket> sent;

    private LinkSocket(Consumer<String> received, Runnable heard, Consumer<String> closed) {
        this.received = received;
        this.heard = heard;
        this.closed = closed;
        sent = new CompletableFuture<>();
    }

    /**
     * Connects.
     *
     * @param within until the server has answered
     * @param heard run when anything has arrived
     * @param closed given why it ended, once it was open; may be empty text
     */
    static CompletionStage<LinkSocket> connect(
            HttpClient client,
            SessionAddress address,
            Duration within,
            Consumer<String> received,
            Runnable heard,
            Consumer<String> closed) {
        LinkSocket socket = new LinkSocket(received, heard, closed);
        return client.newWebSocketBuilder()
                .connectTimeout(within)
                .buildAsync(address.link(), socket)
                .thenApply(open -> {
                    socket.open(open);
                    return socket;
                });
    }

    private synchronized void open(WebSocket open) {
        sent.complete(open);
    }

    /** Sends a text after the texts before it. A text that cannot be sent ends the connection, and the listener is told. */
    synchronized void send(String text) {
        sent = sent.thenCompose(open -> open.sendText(text, true));
    }

    /** Cuts it off at once. */
    synchronized void cut() {
        var unused = sent.whenComplete((open, fault) -> {
            if (open != null) {
                open.abort();
            }
        });
    }

    /** Closes it in order. */
    synchronized CompletionStage<WebSocket> close() {
        sent = sent.thenCompose(open -> open.sendClose(WebSocket.NORMAL_CLOSURE, ""));
        return sent;
    }

    @Override
    public CompletionStage<?> onText(WebSocket from, CharSequence data, boolean last) {
        heard.run();
        part.append(data);
        if (last) {
            received.accept(part.toString());
            part.setLength(0);
        }
        from.request(1);
        return CompletableFuture.completedFuture(null);
    }

    @Override
    public CompletionStage<?> onPing(WebSocket from, ByteBuffer message) {
        heard.run();
        from.request(1);
        return CompletableFuture.completedFuture(null);
    }

    @Override
    public CompletionStage<?> onClose(WebSocket from, int code, String reason) {
        closed.accept(reason);
        return CompletableFuture.completedFuture(null);
    }

    @Override
    public void onError(WebSocket from, Throwable fault) {
        closed.accept(String.valueOf(fault.getMessage()));
    }
}
