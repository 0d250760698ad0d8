package org.sami.session.server;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.http.HttpMethod;
import org.eclipse.jetty.http.HttpStatus;
import org.eclipse.jetty.server.Handler;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.util.Callback;
import org.sami.crw.session.fault.ThreadGuard;
import org.sami.session.person.Person;

/**
 * Serves what only fronts that have logged in may fetch: they show their ticket as {@code Authorization: Bearer TICKET}. Nothing of it may be stored on its way. What waits for disks or boats
 * is done on threads of its own. Passes on all other requests.
 */
abstract class TicketHandler extends Handler.Wrapper implements AutoCloseable {
    private static final String BEARER = "Bearer ";
    private static final int MOST_WAITING = 100;
    private static final int IDLE_S = 10;

    private final Function<String, Optional<Person>> tickets;
    private final SessionBases bases;
    private final String name;
    private final ThreadGuard guard;
    private final ThreadPoolExecutor worker;

    /**
     * A handler whose work is done on so many threads of a name.
     *
     * @param tickets the person who has a ticket; empty for a wrong one
     * @param bases whose pages may fetch it too, after a take-over
     * @param threads at most
     * @param guard is told what work throws
     */
    TicketHandler(
            Function<String, Optional<Person>> tickets,
            SessionBases bases,
            String name,
            int threads,
            ThreadGuard guard) {
        this.name = name;
        this.guard = guard;
        this.bases = bases;
        this.tickets = tickets;
        worker = new ThreadPoolExecutor(
                threads, threads, IDLE_S, TimeUnit.SECONDS, new LinkedBlockingQueue<>(MOST_WAITING), work -> {
                    Thread thread = new Thread(work, name);
                    thread.setDaemon(true);
                    return thread;
                });
        worker.allowCoreThreadTimeOut(true);
    }

    /** Whether a path is served here. */
    abstract boolean serves(String path);

    /** Serves a request of a person who is logged in: sends a response, now or later. */
    abstract void serve(Person person, Request request, Response response, Callback callback);

    @Override
    public final boolean handle(Request request, Response response, Callback callback) throws Exception {
        boolean asks = HttpMethod.OPTIONS.is(request.getMethod()); // a browser, whether a page of another base may
        if (!serves(Request.getPathInContext(request)) || !(asks || HttpMethod.GET.is(request.getMethod()))) {
            return super.handle(request, response, callback);
        }
        bases.letPagesRead(request, response);
        if (asks) {
            response.getHeaders().put(HttpHeader.ACCESS_CONTROL_ALLOW_HEADERS, "Authorization");
            send(response, HttpStatus.NO_CONTENT_204, new byte[0], callback);
            return true;
        }
        response.getHeaders()
                .put("Content-Security-Policy", "default-src 'none'; sandbox; frame-ancestors 'none'")
                .put("X-Content-Type-Options", "nosniff")
                .put("Referrer-Policy", "no-referrer")
                .put("Cross-Origin-Resource-Policy", "same-origin")
                .put(HttpHeader.CACHE_CONTROL, "no-store");
        String shown = Optional.ofNullable(request.getHeaders().get(HttpHeader.AUTHORIZATION))
                .orElse("");
        Optional<Person> person =
                shown.startsWith(BEARER) ? tickets.apply(shown.substring(BEARER.length())) : Optional.empty();
        if (person.isPresent()) {
            serve(person.get(), request, response, callback);
        } else {
            send(response, HttpStatus.UNAUTHORIZED_401, new byte[0], callback);
        }
        return true;
    }

    /**
     * Does something on the threads of this handler, which sends the response, or fails it before it throws. Where too much waits, the client is asked to come again. What is thrown, also where memory
     * runs out, ends this work only and not the session.
     */
    final void work(Response response, Callback callback, Runnable work) {
        try {
            worker.execute(() -> {
                try {
                    work.run();
                } catch (RuntimeException | Error fault) {
                    lost(fault);
                }
            });
        } catch (RejectedExecutionException tooMuch) {
            busy(response, callback);
        }
    }

    /** Tells the session's health that a piece of work was lost. */
    final void lost(Throwable fault) {
        guard.lost(name, fault);
    }

    /** Asks the client to come again in a second. */
    static void busy(Response response, Callback callback) {
        response.getHeaders().put(HttpHeader.RETRY_AFTER, 1);
        send(response, HttpStatus.SERVICE_UNAVAILABLE_503, new byte[0], callback);
    }

    /** Sends words for people. */
    static void say(Response response, int status, String words, Callback callback) {
        response.getHeaders().put(HttpHeader.CONTENT_TYPE, "text/plain; charset=utf-8");
        send(response, status, words.getBytes(StandardCharsets.UTF_8), callback);
    }

    /** Sends a response. */
    static void send(Response response, int status, byte[] content, Callback callback) {
        response.setStatus(status);
        response.getHeaders().put(HttpHeader.CONTENT_LENGTH, content.length);
        response.write(true, ByteBuffer.wrap(content), callback);
    }

    @Override
    public void close() {
        worker.shutdownNow();
    }
}
