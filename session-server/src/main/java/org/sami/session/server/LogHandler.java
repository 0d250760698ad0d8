package org.sami.session.server;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.LongSupplier;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.http.HttpStatus;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.util.Callback;
import org.eclipse.jetty.util.Fields;
import org.sami.boat.link.KeptFile;
import org.sami.boat.link.security.LinkRefusedException;
import org.sami.crw.proxy.file.BoatFileSource;
import org.sami.crw.proxy.file.FileFetchException;
import org.sami.crw.session.fault.ThreadGuard;
import org.sami.session.api.LinkedBoat;
import org.sami.session.api.RefusedException;
import org.sami.session.person.Person;
import org.sami.session.person.Right;

/**
 * Serves the logs that boats keep, to people who may drive them: {@code /logs?boat=B} lists them, {@code /log?boat=B&name=N&from=K&most=M} gives the bytes of one from an offset on, up to {@value #MOST_BYTES} at once.
 * They come from the boat for each request, and are kept nowhere here (docs/session-link.md). What refuses them says why in words.
 */
final class LogHandler extends TicketHandler {
    /** The bytes that are given at once; 40 pieces of a boat, so that progress is seen on a slow link. */
    static final int MOST_BYTES = 240_000;

    /** Each waits for one boat; the fetch of a fleet's logs asks several at once. */
    private static final int MOST_BOATS_AT_ONCE = 8;

    private final LogBoats fleet;
    private final LogNews news;
    private final LongSupplier nanos;

    /**
     * Serves logs.
     *
     * @param news is told who fetches which boat's
     * @param nanos a clock that only goes on
     */
    LogHandler(
            LogBoats fleet,
            Function<String, Optional<Person>> tickets,
            SessionBases bases,
            LogNews news,
            LongSupplier nanos,
            ThreadGuard guard) {
        super(tickets, bases, "session server logs", MOST_BOATS_AT_ONCE, guard);
        this.fleet = fleet;
        this.news = news;
        this.nanos = nanos;
    }

    /** Whether somebody waits for an answer still; where not, the link to the boat is closed, which ends each wait for the boat. Safe for use by several threads. */
    private static final class Waiting {
        private Optional<BoatFileSource> used = Optional.empty(); // this and the next are guarded by this
        private boolean over;

        synchronized void use(BoatFileSource files) throws IOException {
            if (over) {
                throw new IOException("the client has gone");
            }
            used = Optional.of(files);
        }

        synchronized boolean isOver() {
            return over;
        }

        synchronized void end() {
            over = true;
            try {
                if (used.isPresent()) {
                    used.get().close();
                }
            } catch (IOException broken) {
                // it is closed for us all the same
            }
        }
    }

    /** What is asked of a boat. */
    @FunctionalInterface
    private interface Question {
        byte[] ask(BoatFileSource boat) throws IOException;
    }

    @Override
    boolean serves(String path) {
        return isOfLogs(path);
    }

    /** Whether logs are asked for. */
    static boolean isOfLogs(String path) {
        return path.equals("/logs") || path.equals("/log");
    }

    @Override
    void serve(Person person, Request request, Response response, Callback callback) {
        try {
            Rights.require(person, Right.DRIVE);
        } catch (RefusedException refused) {
            say(response, HttpStatus.FORBIDDEN_403, RefusedException.reason(refused), callback);
            return;
        }
        Fields asked = Request.extractQueryParameters(request);
        String boat = text(asked, "boat");
        boolean lists = Request.getPathInContext(request).equals("/logs");
        String name = text(asked, "name");
        Optional<Long> from = number(text(asked, "from"));
        Optional<Long> most = number(text(asked, "most")).filter(one -> one > 0);
        if (!lists && (from.isEmpty() || most.isEmpty() || !KeptFile.isName(name))) {
            say(
                    response,
                    HttpStatus.BAD_REQUEST_400,
                    "'name' is that of a file, 'from' its byte from 0 on, 'most' how many from there on",
                    callback);
            return;
        }
        Waiting waiting = new Waiting();
        request.addFailureListener(fault -> waiting.end());
        Question question = lists
                ? LogHandler::list
                : files -> new TimedPiece(nanos, waiting::isOver)
                        .read(files, name, from.get(), (int) Math.min(MOST_BYTES, most.get()));
        fleet.find(boat).whenComplete((found, fault) -> {
            try {
                Optional<LinkedBoat> link = fault == null ? found.link() : Optional.empty();
                if (link.isEmpty()) {
                    // a base that has just taken over makes its links first
                    boolean mayCome = fault != null || found.mayCome();
                    int status = mayCome ? HttpStatus.SERVICE_UNAVAILABLE_503 : HttpStatus.NOT_FOUND_404;
                    say(response, status, "the base has no link to a boat '" + boat + "'", callback);
                    return;
                }
                if (lists) {
                    news.fetches(person, boat);
                }
                response.getHeaders()
                        .put(HttpHeader.CONTENT_TYPE, lists ? "application/json" : "application/octet-stream");
                work(response, callback, () -> answer(link.get(), question, waiting, response, callback));
            } catch (RuntimeException | Error thrown) { // nobody looks at what comes of this stage
                callback.failed(thrown);
                lost(thrown);
            }
        });
    }

    private static String text(Fields asked, String name) {
        return Optional.ofNullable(asked.getValue(name)).orElse("");
    }

    private static Optional<Long> number(String text) {
        return text.matches("[0-9]{1,10}") ? Optional.of(Long.parseLong(text)) : Optional.empty();
    }

    private void answer(LinkedBoat boat, Question question, Waiting waiting, Response response, Callback callback) {
        try (BoatFileSource files = fleet.files(boat)) {
            waiting.use(files);
            files.open();
            if (!files.boatId().equals(boat.boat())) {
                throw new FileFetchException(
                        "at " + boat.address() + " answers " + files.boatId() + ", not " + boat.boat());
            }
            send(response, HttpStatus.OK_200, question.ask(files), callback);
        } catch (FileFetchException | LinkRefusedException refused) {
            say(response, HttpStatus.BAD_GATEWAY_502, words(refused), callback);
        } catch (IOException notReached) {
            say(response, HttpStatus.SERVICE_UNAVAILABLE_503, words(notReached), callback);
        } catch (RuntimeException | Error fault) {
            callback.failed(fault);
            throw fault;
        }
    }

    private static String words(IOException fault) {
        return fault.getMessage() == null ? fault.toString() : fault.getMessage();
    }

    private static byte[] list(BoatFileSource boat) throws IOException {
        ObjectNode all = JsonNodeFactory.instance.objectNode();
        ArrayNode files = all.putArray("files");
        for (KeptFile file : boat.list(KeptFile.LOG)) {
            files.addObject()
                    .put("name", file.name())
                    .put("bytes", file.bytes())
                    .put("sha256", file.sha256());
        }
        return all.toString().getBytes(StandardCharsets.UTF_8);
    }
}
