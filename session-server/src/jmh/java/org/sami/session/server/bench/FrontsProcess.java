package org.sami.session.server.bench;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.atomic.AtomicLong;

/** Fronts of a session in a process of their own, so that what they need is not counted for the host. They count what reaches them. */
final class FrontsProcess implements AutoCloseable {
    private final Process process;
    private final BufferedReader out;
    private final PrintStream in;

    /**
     * Begins the process, and waits until all its fronts are logged in.
     *
     * @param url of the session's server, which asks for no keys
     */
    FrontsProcess(String url, int fronts) throws IOException {
        process = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-cp",
                        System.getProperty("java.class.path"),
                        FrontsProcess.class.getName(),
                        url,
                        "" + fronts)
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        out = new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
        in = new PrintStream(process.getOutputStream(), true, StandardCharsets.UTF_8);
        bytes();
    }

    /** What each front has received so far: bytes of text in UTF-8, without the WebSocket's headers of 2 to 10 bytes a frame. */
    List<Long> bytes() throws IOException {
        in.println();
        String line = out.readLine();
        if (line == null) {
            throw new IOException("the fronts' process has ended");
        }
        List<Long> counts = new ArrayList<>();
        for (String count : line.split(" ")) {
            counts.add(Long.parseLong(count));
        }
        return counts;
    }

    @Override
    public void close() throws InterruptedException {
        process.destroy();
        process.waitFor();
    }

    /** The fronts' process, given the server's URL and their number: prints a line of counts for each line that it reads, and ends with its input. */
    public static void main(String[] args) throws IOException {
        HttpClient client = HttpClient.newHttpClient();
        List<Front> fronts = new ArrayList<>();
        for (int i = 1; i <= Integer.parseInt(args[1]); i++) {
            fronts.add(new Front(client, args[0], "front" + i));
        }
        BufferedReader in = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        while (in.readLine() != null) {
            StringBuilder line = new StringBuilder();
            fronts.forEach(front -> line.append(line.isEmpty() ? "" : " ").append(front.bytes.get()));
            System.out.println(line);
        }
        System.exit(0);
    }

    private static final class Front implements WebSocket.Listener {
        private final AtomicLong bytes = new AtomicLong();

        Front(HttpClient client, String url, String name) {
            URI at = URI.create(url.replaceFirst("^http", "ws") + "session");
            WebSocket socket = client.newWebSocketBuilder().buildAsync(at, this).join();
            socket.sendText("{\"t\":\"hello\",\"v\":1,\"name\":\"" + name + "\"}", true)
                    .join();
        }

        @Override
        public CompletionStage<?> onText(WebSocket socket, CharSequence text, boolean last) {
            bytes.addAndGet(text.toString().getBytes(StandardCharsets.UTF_8).length);
            socket.request(1);
            return null;
        }

        @Override
        public CompletionStage<?> onClose(WebSocket socket, int code, String reason) {
            System.err.println("the server has closed a front: " + code + " " + reason);
            return null;
        }
    }
}
