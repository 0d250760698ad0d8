package org.sami.boat.hull.board;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.sami.boat.hull.stream.LineSplitter;
import org.sami.boat.hull.stream.StreamConnection;
import org.sami.boat.hull.stream.StreamPort;

/** A board on streams of this process, which can be pulled and put back. */
final class TestBoard implements StreamPort {
    final List<String> commands = new CopyOnWriteArrayList<>();
    private volatile boolean pulled;
    private volatile Optional<OutputStream> toBoat = Optional.empty();
    private volatile Optional<PipedInputStream> inOfBoat = Optional.empty();

    @Override
    public String name() {
        return "test board";
    }

    @Override
    public StreamConnection open() throws IOException {
        if (pulled) {
            throw new IOException("the cable is out");
        }
        PipedInputStream in = new PipedInputStream(1 << 16);
        PipedOutputStream out = new PipedOutputStream(in);
        inOfBoat = Optional.of(in);
        toBoat = Optional.of(out);
        LineSplitter splitter = new LineSplitter(512, commands::add);
        return new StreamConnection() {
            @Override
            public InputStream in() {
                return in;
            }

            @Override
            public OutputStream out() {
                return new OutputStream() {
                    @Override
                    public void write(int one) throws IOException {
                        write(new byte[] {(byte) one});
                    }

                    @Override
                    public void write(byte[] bytes, int from, int count) throws IOException {
                        if (pulled) {
                            throw new IOException("the cable is out");
                        }
                        splitter.feed(Arrays.copyOfRange(bytes, from, from + count), count);
                    }
                };
            }

            @Override
            public void close() throws IOException {
                in.close();
                out.close();
            }
        };
    }

    void say(String line) {
        send((line + "\r\n").getBytes(StandardCharsets.US_ASCII));
    }

    void send(byte[] bytes) {
        try {
            if (toBoat.isPresent()) {
                toBoat.get().write(bytes);
                toBoat.get().flush();
            }
        } catch (IOException gone) {
            // as on a cable
        }
    }

    void pull() throws IOException {
        pulled = true;
        if (toBoat.isPresent()) {
            toBoat.get().close();
            inOfBoat.get().close();
        }
    }

    void putBack() {
        pulled = false;
    }

    String lastCommand() {
        return commands.isEmpty() ? "" : commands.get(commands.size() - 1);
    }
}
