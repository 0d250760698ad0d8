package org.sami.crw.report;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.ref.Cleaner;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.AbstractList;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.RandomAccess;
import java.util.zip.DeflaterOutputStream;
import java.util.zip.InflaterInputStream;

/**
 * A list that only grows, of which no more than two blocks of rows are in memory: the rest is in a file of the system's temporary
 * folder, which goes with the list or with the process. A report contains every firing, and hours of them do not fit into memory.
 * Where that file cannot be written the rows stay in memory. Meant to be read in order. Safe for use by several threads.
 */
public final class SpooledList<T> extends AbstractList<T> implements RandomAccess {
    private static final System.Logger LOG = System.getLogger(SpooledList.class.getName());
    private static final Cleaner CLEANER = Cleaner.create();
    private static final int BLOCK_ROWS = 512;

    /** How a row is written and read. */
    public interface Format<T> {
        /** Writes a row. */
        void write(T row, DataOutputStream out) throws IOException;

        /** Reads what was written. */
        T read(DataInputStream in) throws IOException;
    }

    /** Where a block of rows is: in the file, or in memory. */
    private record Block<T>(long position, int length, List<T> rows) {}

    private final Format<T> format;
    private final List<Block<T>> blocks = new ArrayList<>();
    private final List<T> newest = new ArrayList<>();
    private Optional<FileChannel> file = Optional.empty();
    private boolean isInMemory;
    private int loadedBlock = -1;
    private List<T> loaded = List.of();

    /** An empty list. */
    public SpooledList(Format<T> format) {
        this.format = format;
    }

    @Override
    public synchronized boolean add(T row) {
        newest.add(row);
        if (newest.size() == BLOCK_ROWS) {
            blocks.add(stored(List.copyOf(newest)));
            newest.clear();
        }
        return true;
    }

    @Override
    public synchronized int size() {
        return blocks.size() * BLOCK_ROWS + newest.size();
    }

    @Override
    public synchronized T get(int index) {
        int block = index / BLOCK_ROWS;
        if (block >= blocks.size()) {
            return newest.get(index - blocks.size() * BLOCK_ROWS);
        }
        if (block != loadedBlock) {
            loaded = rows(blocks.get(block));
            loadedBlock = block;
        }
        return loaded.get(index % BLOCK_ROWS);
    }

    /** The rows so far, unmodifiable, and not more when more are added. */
    public List<T> soFar() {
        return new SoFar<>(this, size());
    }

    /** An unmodifiable list of the same rows, which is a copy only where they are in memory anyway. */
    public static <T> List<T> copyOf(List<T> rows) {
        if (rows instanceof SoFar<T>) {
            return rows;
        }
        return rows instanceof SpooledList<T> spool ? spool.soFar() : List.copyOf(rows);
    }

    private Block<T> stored(List<T> rows) {
        if (!isInMemory) {
            try {
                byte[] bytes = bytes(rows);
                FileChannel channel = channel();
                long position = channel.size();
                ByteBuffer buffer = ByteBuffer.wrap(bytes);
                while (buffer.hasRemaining()) {
                    channel.write(buffer, position + buffer.position());
                }
                return new Block<>(position, bytes.length, List.of());
            } catch (IOException fault) {
                isInMemory = true;
                LOG.log(System.Logger.Level.WARNING, "what the report will tell stays in memory: " + fault);
            }
        }
        return new Block<>(0, 0, rows);
    }

    private FileChannel channel() throws IOException {
        if (file.isEmpty()) {
            Path path = Files.createTempFile("crw-", ".rows");
            FileChannel opened = FileChannel.open(
                    path, StandardOpenOption.READ, StandardOpenOption.WRITE, StandardOpenOption.DELETE_ON_CLOSE);
            CLEANER.register(this, () -> close(opened));
            file = Optional.of(opened);
        }
        return file.get();
    }

    private static void close(FileChannel opened) {
        try {
            opened.close();
        } catch (IOException e) {
            LOG.log(System.Logger.Level.DEBUG, "a temporary file stays behind", e);
        }
    }

    private byte[] bytes(List<T> rows) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(new DeflaterOutputStream(bytes))) {
            for (T row : rows) {
                format.write(row, out);
            }
        }
        return bytes.toByteArray();
    }

    private List<T> rows(Block<T> block) {
        if (!block.rows.isEmpty()) {
            return block.rows;
        }
        List<T> rows = new ArrayList<>(BLOCK_ROWS);
        try (DataInputStream in =
                new DataInputStream(new InflaterInputStream(new ByteArrayInputStream(bytes(block))))) {
            for (int i = 0; i < BLOCK_ROWS; i++) {
                rows.add(format.read(in));
            }
        } catch (IOException e) {
            throw new UncheckedIOException("the temporary file of the report cannot be read: " + e.getMessage(), e);
        }
        return rows;
    }

    private byte[] bytes(Block<T> block) throws IOException {
        ByteBuffer buffer = ByteBuffer.allocate(block.length);
        while (buffer.hasRemaining()) {
            if (file.orElseThrow().read(buffer, block.position + buffer.position()) < 0) {
                throw new EOFException("it is shorter than it was");
            }
        }
        return buffer.array();
    }

    /** The first rows of a spool. */
    private static final class SoFar<T> extends AbstractList<T> implements RandomAccess {
        private final SpooledList<T> spool;
        private final int size;

        SoFar(SpooledList<T> spool, int size) {
            this.spool = spool;
            this.size = size;
        }

        @Override
        public T get(int index) {
            if (index >= size) {
                throw new IndexOutOfBoundsException("row " + index + " of " + size);
            }
            return spool.get(index);
        }

        @Override
        public int size() {
            return size;
        }
    }
}
