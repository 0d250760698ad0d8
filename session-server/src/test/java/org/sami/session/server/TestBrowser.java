package org.sami.session.server;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.BufferedReader;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.WebSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;
import org.sami.boat.server.testing.Await;

/** A headless Chromium with one page of a phone's size, driven by its DevTools protocol. */
final class TestBrowser implements AutoCloseable {
    private static final Pattern LISTENS = Pattern.compile("DevTools listening on ws://([^/]+)/");
    private static final ObjectMapper JSON = new ObjectMapper();

    private final Process process;
    private final WebSocket socket;
    private final Map<Integer, CompletableFuture<JsonNode>> asked = new ConcurrentHashMap<>();
    private int ids;

    /** The browser that is installed; empty where there is none. */
    static Optional<Path> installed() {
        return Stream.of("/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome")
                .map(Path::of)
                .filter(Files::isExecutable)
                .findFirst();
    }

    TestBrowser(Path program, Path profile) throws Exception {
        ProcessBuilder builder = new ProcessBuilder(
                        program.toString(),
                        "--headless",
                        "--no-sandbox",
                        "--disable-gpu",
                        "--disable-background-networking",
                        "--remote-debugging-port=0",
                        "--window-size=390,844",
                        "--user-data-dir=" + profile,
                        "about:blank")
                .redirectErrorStream(true);
        builder.environment().put("TMPDIR", Files.createDirectories(profile).toString()); // it leaves nothing elsewhere
        process = builder.start();
        HttpClient client = HttpClient.newHttpClient();
        URI pages = URI.create("http://" + port(process) + "/json/list");
        String page = "";
        while (page.isEmpty()) {
            HttpResponse<String> list =
                    client.send(HttpRequest.newBuilder(pages).build(), HttpResponse.BodyHandlers.ofString());
            page = StreamSupport.stream(JSON.readTree(list.body()).spliterator(), false)
                    .filter(one -> one.path("type").asText().equals("page"))
                    .map(one -> one.path("webSocketDebuggerUrl").asText())
                    .findFirst()
                    .orElse("");
        }
        socket = client.newWebSocketBuilder()
                .buildAsync(URI.create(page), new Answers())
                .join();
    }

    private static String port(Process browser) throws IOException {
        BufferedReader lines = browser.inputReader();
        for (String line = lines.readLine(); line != null; line = lines.readLine()) {
            Matcher listens = LISTENS.matcher(line);
            if (listens.find()) {
                Thread rest = new Thread(() -> lines.lines().forEach(more -> {}), "browser's words");
                rest.setDaemon(true);
                rest.start();
                return listens.group(1);
            }
        }
        throw new IOException("the browser has ended before it listened");
    }

    private JsonNode ask(String method, ObjectNode parameters) {
        int id = ++ids;
        CompletableFuture<JsonNode> answer = new CompletableFuture<>();
        asked.put(id, answer);
        ObjectNode message = JSON.createObjectNode().put("id", id).put("method", method);
        message.set("params", parameters);
        socket.sendText(message.toString(), true).join();
        return answer.orTimeout(15, TimeUnit.MINUTES).join();
    }

    void open(String url) {
        ask("Page.navigate", JSON.createObjectNode().put("url", url));
    }

    /** The value of an expression of JavaScript. */
    JsonNode value(String expression) {
        JsonNode result = ask(
                "Runtime.evaluate",
                JSON.createObjectNode().put("expression", expression).put("returnByValue", true));
        return result.path("result").path("result").path("value");
    }

    /** Waits until an expression is true; else says what the page shows. */
    void until(String expression) {
        try {
            Await.until(expression, () -> value(expression).asBoolean());
        } catch (AssertionError tooLate) {
            throw new AssertionError(
                    tooLate.getMessage() + "; the page shows: "
                            + value("document.body.innerText").asText(),
                    tooLate);
        }
    }

    /** Waits for an element and clicks it. */
    void click(String selector) {
        until("document.querySelector(`" + selector + "`) !== null");
        value("document.querySelector(`" + selector + "`).click()");
    }

    /** Types into an element. */
    void type(String selector, String text) {
        until("document.querySelector(`" + selector + "`) !== null");
        value("document.querySelector(`" + selector + "`).value = '" + text + "'");
    }

    /** Presses the mouse somewhere, and lets it go. */
    void press(double x, double y) {
        for (String type : new String[] {"mouseMoved", "mousePressed", "mouseReleased"}) {
            mouse(type, x, y);
        }
    }

    void mouse(String type, double x, double y) {
        ask(
                "Input.dispatchMouseEvent",
                JSON.createObjectNode()
                        .put("type", type)
                        .put("x", x)
                        .put("y", y)
                        .put("button", "left")
                        .put("clickCount", 1));
    }

    /** The middle of an element, in the page. */
    double[] middle(String selector) {
        JsonNode at = value("(() => { const r = document.querySelector(`" + selector
                + "`).getBoundingClientRect(); return {x: r.x + r.width / 2, y: r.y + r.height / 2}; })()");
        return new double[] {at.path("x").asDouble(), at.path("y").asDouble()};
    }

    @Override
    public void close() throws InterruptedException {
        socket.sendText("{\"id\":0,\"method\":\"Browser.close\"}", true).join();
        if (!process.waitFor(1, TimeUnit.MINUTES)) {
            process.descendants().forEach(ProcessHandle::destroyForcibly);
            process.destroyForcibly().waitFor();
        }
        socket.abort();
    }

    private final class Answers implements WebSocket.Listener {
        private final StringBuilder part = new StringBuilder();

        @Override
        public CompletionStage<?> onText(WebSocket from, CharSequence text, boolean last) {
            part.append(text);
            if (last) {
                try {
                    JsonNode message = JSON.readTree(part.toString());
                    Optional.ofNullable(asked.remove(message.path("id").asInt()))
                            .ifPresent(waiting -> waiting.complete(message));
                } catch (IOException e) {
                    throw new IllegalStateException(e);
                } finally {
                    part.setLength(0);
                }
            }
            from.request(1);
            return null;
        }
    }
}
