package org.sami.crw.proxy.file;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.sami.boat.link.FileAnswer;
import org.sami.boat.link.FileList;
import org.sami.boat.link.FilePiece;
import org.sami.boat.link.FileRefusal;
import org.sami.boat.link.FileRequest;
import org.sami.boat.link.Frame;
import org.sami.boat.link.FrameReader;
import org.sami.boat.link.GetPiece;
import org.sami.boat.link.Goodbye;
import org.sami.boat.link.Heartbeat;
import org.sami.boat.link.Hello;
import org.sami.boat.link.KeptFile;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.ListFiles;
import org.sami.boat.link.Nack;
import org.sami.boat.link.Role;
import org.sami.boat.link.Welcome;
import org.sami.boat.link.security.LinkSecurity;
import org.sami.boat.link.security.SecureLink;

/** A boat's files over a link to the boat itself, over TCP. It observes, and commands nothing. */
public final class BoatFileLink implements BoatFileSource {
    private static final int WITHIN_MS = 10_000;
    private static final int MOST_FILES = 100_000;
    private static final String NOT_OPEN = "the link is not open";

    private final InetSocketAddress address;
    private final LinkSecurity security;
    private final Socket socket = new Socket(); // made at once, so that a link that is being made can be closed
    private @Nullable FrameReader frames; // this and the next: not null once it is open
    private @Nullable OutputStream out;
    private String boatId = "";
    private long sequence;
    private long requests;

    /**
     * A link that is not made yet.
     *
     * @param security such as {@code BaseProtection.ofThisProcess()}
     */
    public BoatFileLink(InetSocketAddress address, LinkSecurity security) {
        this.address = Objects.requireNonNull(address, "address");
        this.security = Objects.requireNonNull(security, "security");
    }

    @Override
    public void open() throws IOException {
        try {
            socket.setTcpNoDelay(true);
            socket.connect(new InetSocketAddress(address.getHostString(), address.getPort()), WITHIN_MS);
            socket.setSoTimeout(WITHIN_MS); // the boat says something once a second
            SecureLink link = security.connect(socket);
            frames = new FrameReader(new BufferedInputStream(link.in()), LinkCodec.STANDARD);
            out = link.out();
            greet();
        } catch (IOException | RuntimeException e) {
            socket.close();
            throw e;
        }
    }

    private void greet() throws IOException {
        say(new Hello("", "files-" + UUID.randomUUID(), Role.OBSERVER, 0, ""));
        LinkMessage message = next();
        while (!(message instanceof Welcome)) {
            message = next();
        }
        boatId = ((Welcome) message).boatId();
    }

    @Override
    public String boatId() {
        return boatId;
    }

    @Override
    public List<KeptFile> list(String kind) throws IOException {
        List<KeptFile> all = new ArrayList<>();
        String after = "";
        boolean more = true;
        while (more && all.size() < MOST_FILES) {
            FileAnswer answer = ask(new ListFiles(nextId(), kind, after));
            if (!(answer instanceof FileList page)) {
                throw refused(answer);
            }
            all.addAll(page.files());
            more = page.more() && !page.files().isEmpty();
            after = more ? page.files().get(page.files().size() - 1).name() : after;
        }
        return all;
    }

    @Override
    public byte[] piece(String name, long offset, int atMost) throws IOException {
        FileAnswer answer = ask(new GetPiece(nextId(), name, offset, Math.min(atMost, FilePiece.MAX_BYTES)));
        if (answer instanceof FilePiece piece
                && piece.offset() == offset
                && piece.name().equals(name)) {
            return piece.content();
        }
        throw refused(answer);
    }

    private FileFetchException refused(FileAnswer answer) {
        return answer instanceof FileRefusal refusal
                ? new FileFetchException(boatId + ": " + refusal.detail())
                : new FileFetchException(boatId + " answers something else than was asked");
    }

    private String nextId() {
        return "r" + requests++;
    }

    private FileAnswer ask(FileRequest request) throws IOException {
        say(request);
        while (true) {
            LinkMessage message = next();
            if (message instanceof FileAnswer answer && answer.requestId().equals(request.requestId())) {
                return answer;
            } else if (message instanceof Nack) { // its codec does not know what is asked
                throw new FileFetchException(boatId + ": its server gives no files yet; bring it to this version");
            } else {
                say(new Heartbeat(System.nanoTime() / 1_000_000)); // while the boat reads its disk
            }
        }
    }

    private LinkMessage next() throws IOException {
        try {
            Optional<byte[]> frame = Objects.requireNonNull(frames, NOT_OPEN).next();
            if (frame.isEmpty()) {
                throw new IOException("the boat has closed the link");
            }
            LinkMessage message = LinkCodec.STANDARD.decode(frame.get()).message();
            if (message instanceof Goodbye goodbye) {
                throw new FileFetchException(goodbye.boatId() + ": " + goodbye.reason());
            }
            return message;
        } catch (LinkException e) {
            boolean cut = e.fault() == LinkException.Fault.TRUNCATED;
            String what = cut ? "the link broke: " : "what answers there is no boat of this version: ";
            throw cut ? new IOException(what + e.getMessage(), e) : new FileFetchException(what + e.getMessage());
        }
    }

    private void say(LinkMessage message) throws IOException {
        OutputStream to = Objects.requireNonNull(out, NOT_OPEN);
        to.write(LinkCodec.STANDARD.encode(new Frame(sequence++, "", message)));
        to.flush();
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }
}
