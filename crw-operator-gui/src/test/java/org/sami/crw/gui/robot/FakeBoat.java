package org.sami.crw.gui.robot;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.zip.CRC32;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.FrameReader;
import org.sami.boat.link.Gains;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Progress;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.link.Telemetry;
import org.sami.crw.gui.LoopbackFleet;
import org.sami.crw.proxy.tcp.BoatAddress;

/** What answers as a boat behind a loopback socket, takes every command, and then says whatever it is given to say. */
final class FakeBoat implements AutoCloseable {
    /** What it says once it has been greeted as the boat that it is. */
    interface Speech {
        /** Says it; the connection stays until the base closes it.
         *
         * @param connection the number of the connection, from 0
         */
        void on(int connection, FakeBoat.Mouth mouth) throws IOException;
    }

    /** By which name it is known on a connection: as JSON writes it in quotes. */
    interface Name {
        String on(int connection);
    }

    private static final Gains GAINS = new Gains(1, 0, 0);

    /** The types of the commands that it was given. */
    final ConcurrentLinkedQueue<String> commands = new ConcurrentLinkedQueue<>();

    private final AtomicInteger connections = new AtomicInteger();
    private final List<Socket> open = new CopyOnWriteArrayList<>();
    private final ServerSocket socket = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
    private final Name name;
    private final Speech speech;

    /** A boat of one name. */
    FakeBoat(String id, Speech speech) throws IOException {
        this(connection -> id, speech);
    }

    /** A boat that goes by a name on each connection. */
    FakeBoat(Name name, Speech speech) throws IOException {
        this.name = name;
        this.speech = speech;
        daemon(this::accept);
    }

    BoatAddress address() {
        return new BoatAddress("127.0.0.1", socket.getLocalPort());
    }

    /** How often somebody has connected. */
    int connections() {
        return connections.get();
    }

    private static void daemon(Runnable work) {
        Thread thread = new Thread(work, "fake-boat");
        thread.setDaemon(true);
        thread.start();
    }

    private void accept() {
        while (!socket.isClosed()) {
            try {
                Socket base = socket.accept();
                open.add(base);
                int number = connections.getAndIncrement();
                daemon(() -> answer(base, number));
            } catch (IOException closed) {
                return;
            }
        }
    }

    private void answer(Socket base, int number) {
        boolean speaks = false;
        try (base) {
            Mouth mouth = new Mouth(base.getOutputStream());
            FrameReader frames = new FrameReader(new BufferedInputStream(base.getInputStream()), new LinkCodec());
            String id = name.on(number);
            for (Optional<byte[]> next = frames.next(); next.isPresent(); next = frames.next()) {
                LinkMessage message = LinkCodec.STANDARD.decode(next.get()).message();
                if (message instanceof Hello hello) {
                    mouth.sayText("{\"type\":\"welcome\",\"seq\":0,\"boat\":\"" + id
                            + "\",\"boot\":\"boot\",\"role\":\"" + hello.role()
                            + "\",\"newTerm\":\"boot.1\",\"auth\":\"\"}"); // a welcome of ours holds no such names
                    mouth.say(new SettingsReport(GAINS, GAINS, 1, LostLinkAction.HOLD));
                    mouth.say(new Progress("", 0, false));
                    if (!speaks && !hello.boatId().isEmpty()) {
                        speaks = true;
                        daemon(() -> speak(number, mouth));
                    }
                } else if (message instanceof CommandMessage command) {
                    commands.add(command.type());
                    mouth.say(new Ack(command.commandId()));
                }
            }
        } catch (IOException | LinkException closed) {
            // the base or the test has had enough
        } finally {
            open.remove(base);
        }
    }

    private void speak(int number, Mouth mouth) {
        try {
            speech.on(number, mouth);
        } catch (IOException | UncheckedIOException closed) {
            // it goes on over the next connection
        }
    }

    /** What a boat says that lies so far east of the quay, in degrees. */
    static Telemetry at(double eastDeg, long timeMs) {
        return new Telemetry(
                LoopbackFleet.QUAY.latDeg(), LoopbackFleet.QUAY.lonDeg() + eastDeg, 0, 0, 90, BoatMode.STOPPED, timeMs);
    }

    @Override
    public void close() throws IOException {
        socket.close();
        for (Socket each : open) {
            each.close();
        }
    }

    /** What it says over one connection, which several threads say. */
    static final class Mouth {
        private final OutputStream out;
        private long sequence;

        Mouth(OutputStream out) {
            this.out = out;
        }

        /** Says a message. */
        synchronized void say(LinkMessage message) throws IOException {
            out.write(LinkCodec.STANDARD.encode(sequence++, message));
        }

        /** Says a frame whose body is any text. */
        synchronized void sayText(String body) throws IOException {
            byte[] text = body.getBytes(StandardCharsets.UTF_8);
            byte[] head = ByteBuffer.allocate(5)
                    .putInt(text.length + 5)
                    .put((byte) LinkCodec.VERSION)
                    .array();
            CRC32 check = new CRC32();
            check.update(head);
            check.update(text);
            out.write(ByteBuffer.allocate(text.length + 9)
                    .put(head)
                    .putInt((int) check.getValue())
                    .put(text)
                    .array());
        }

        /** Sends bytes as they are. */
        synchronized void sendRaw(byte[] bytes) throws IOException {
            out.write(bytes);
        }

        /** Closes the connection. */
        void hangUp() throws IOException {
            out.close();
        }
    }
}
