package org.sami.boat.server.file;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Predicate;
import org.sami.boat.link.FileAnswer;
import org.sami.boat.link.FileList;
import org.sami.boat.link.FilePiece;
import org.sami.boat.link.FileRefusal;
import org.sami.boat.link.FileRefusal.Reason;
import org.sami.boat.link.FileRequest;
import org.sami.boat.link.GetPiece;
import org.sami.boat.link.KeptFile;
import org.sami.boat.link.ListFiles;

/**
 * The files that one boat gives to its clients: some files of some folders, each folder of one kind. A client names a file as it is listed; no other
 * file is opened, and no link to one followed. A file that is still being written must have another name until it is whole (such as one ending in
 * {@code .part}), unless it only grows, as a log does.
 *
 * <p>Reads disks, so not for the thread that drives the boat. Safe for use by several threads.
 */
public final class BoatFiles {
    private static final int BUFFER_BYTES = 64 << 10;

    private final List<Source> sources;
    private final Map<Path, Hash> hashes = new HashMap<>(); // guarded by itself

    private BoatFiles(List<Source> sources) {
        this.sources = sources;
    }

    /** No files; {@link #with} adds some. */
    public static BoatFiles none() {
        return new BoatFiles(Collections.emptyList());
    }

    /**
     * These files and those of a folder. The folder may come into being later.
     *
     * @param kind of all files in it, such as {@link KeptFile#PICTURE}
     */
    public BoatFiles with(String kind, Path folder) {
        return with(kind, folder, name -> true);
    }

    /** These files, and those of a folder whose names a condition accepts. */
    public BoatFiles with(String kind, Path folder, Predicate<String> names) {
        List<Source> all = new ArrayList<>(sources);
        all.add(new Source(kind, folder, names));
        return new BoatFiles(all);
    }

    /** Answers a request; what cannot be given is refused with its reason. */
    public FileAnswer answer(FileRequest request) {
        try {
            return request instanceof ListFiles ? list((ListFiles) request) : piece((GetPiece) request);
        } catch (IOException | RuntimeException e) {
            return refusal(request, Reason.UNREADABLE, "the boat cannot read it: " + e.getMessage());
        }
    }

    private FileAnswer list(ListFiles request) throws IOException {
        SortedMap<String, Found> all = new TreeMap<>(find());
        List<KeptFile> page = new ArrayList<>();
        boolean more = false;
        for (Map.Entry<String, Found> entry : all.tailMap(request.after()).entrySet()) {
            Found found = entry.getValue();
            boolean wanted = request.kind().isEmpty() || request.kind().equals(found.source.kind);
            if (!wanted || entry.getKey().equals(request.after())) {
                continue;
            }
            if (page.size() == FileList.MAX_FILES) {
                more = true;
                break;
            }
            try {
                page.add(entry(found));
            } catch (NoSuchFileException e) {
                // it has been removed meanwhile
            }
        }
        return new FileList(request.requestId(), page, more);
    }

    private KeptFile entry(Found found) throws IOException {
        BasicFileAttributes attributes = attributes(found.file);
        long bytes = attributes.size();
        String hash = bytes > KeptFile.MAX_BYTES ? "" : hash(found.file, attributes);
        return new KeptFile(found.file.getFileName().toString(), found.source.kind, bytes, hash);
    }

    private FileAnswer piece(GetPiece request) throws IOException {
        Found found = KeptFile.isName(request.name()) ? find().get(request.name()) : null;
        if (found == null) {
            return unknown(request);
        }
        try (FileChannel channel = FileChannel.open(found.file, StandardOpenOption.READ, LinkOption.NOFOLLOW_LINKS)) {
            long size = channel.size();
            if (size > KeptFile.MAX_BYTES) {
                return refusal(
                        request,
                        Reason.TOO_LARGE,
                        request.name() + " has " + size + " bytes; the boat gives files up to " + KeptFile.MAX_BYTES);
            }
            if (request.offset() > size) {
                return refusal(
                        request,
                        Reason.PAST_END,
                        request.name() + " has " + size + " bytes, none from " + request.offset() + " on");
            }
            byte[] content = new byte[(int) Math.min(request.bytes(), size - request.offset())];
            ByteBuffer buffer = ByteBuffer.wrap(content);
            int read = 0;
            while (buffer.hasRemaining() && read >= 0) {
                read = channel.read(buffer, request.offset() + buffer.position());
            }
            byte[] there = buffer.hasRemaining() ? java.util.Arrays.copyOf(content, buffer.position()) : content;
            return new FilePiece(request.requestId(), request.name(), request.offset(), there);
        } catch (NoSuchFileException e) {
            return unknown(request);
        }
    }

    private static FileRefusal unknown(GetPiece request) {
        return refusal(request, Reason.UNKNOWN_FILE, "the boat keeps no file of that name, or does so no longer");
    }

    private static FileRefusal refusal(FileRequest request, Reason reason, String detail) {
        return new FileRefusal(request.requestId(), reason, detail.length() <= 500 ? detail : detail.substring(0, 500));
    }

    /** All files by name; of two with one name the first source's. */
    private Map<String, Found> find() throws IOException {
        Map<String, Found> all = new HashMap<>();
        for (Source source : sources) {
            try (DirectoryStream<Path> files = Files.newDirectoryStream(source.folder)) {
                for (Path file : files) {
                    String name = file.getFileName().toString();
                    boolean taken = KeptFile.isName(name)
                            && !name.endsWith(".part")
                            && source.names.test(name)
                            && Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS);
                    if (taken) {
                        all.putIfAbsent(name, new Found(source, file));
                    }
                }
            } catch (NoSuchFileException | NotDirectoryException e) {
                // nothing has been kept there yet
            }
        }
        return all;
    }

    /** Of the first bytes, as many as there were when it was listed; files that stay as they are are read once. */
    private String hash(Path file, BasicFileAttributes attributes) throws IOException {
        long bytes = attributes.size();
        long changedMs = attributes.lastModifiedTime().toMillis();
        synchronized (hashes) {
            Hash known = hashes.get(file);
            if (known != null && known.bytes == bytes && known.changedMs == changedMs) {
                return known.text;
            }
        }
        String text = hash(file, bytes);
        synchronized (hashes) {
            hashes.put(file, new Hash(bytes, changedMs, text));
        }
        return text;
    }

    private static String hash(Path file, long bytes) throws IOException {
        MessageDigest digest = sha256();
        byte[] buffer = new byte[BUFFER_BYTES];
        try (InputStream in = Files.newInputStream(file)) {
            long left = bytes;
            while (left > 0) {
                int read = in.read(buffer, 0, (int) Math.min(buffer.length, left));
                if (read < 0) {
                    throw new NoSuchFileException(file.toString()); // another one by now
                }
                digest.update(buffer, 0, read);
                left -= read;
            }
        }
        StringBuilder text = new StringBuilder();
        for (byte next : digest.digest()) {
            text.append(String.format("%02x", next & 0xff));
        }
        return text.toString();
    }

    private static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }

    private static BasicFileAttributes attributes(Path file) throws IOException {
        return Files.readAttributes(file, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
    }

    private static final class Source {
        private final String kind;
        private final Path folder;
        private final Predicate<String> names;

        private Source(String kind, Path folder, Predicate<String> names) {
            this.kind = Objects.requireNonNull(kind, "kind");
            this.folder = Objects.requireNonNull(folder, "folder");
            this.names = Objects.requireNonNull(names, "names");
        }
    }

    private static final class Found {
        private final Source source;
        private final Path file;

        private Found(Source source, Path file) {
            this.source = source;
            this.file = file;
        }
    }

    private static final class Hash {
        private final long bytes;
        private final long changedMs;
        private final String text;

        private Hash(long bytes, long changedMs, String text) {
            this.bytes = bytes;
            this.changedMs = changedMs;
            this.text = text;
        }
    }
}
