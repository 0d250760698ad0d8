package org.sami.boat.server.log;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;

/** A disk on which the process ends before a given step, with or without a loss of power, or which is full. */
final class FailingDisk extends LogDisk {
    private final Map<FileChannel, Path> paths = new HashMap<>();
    private final Map<Path, Long> forcedBytes = new HashMap<>();
    private final Map<Path, Path> unforcedNames = new LinkedHashMap<>();
    private final Map<Path, byte[]> unforcedDeletes = new LinkedHashMap<>();
    private final int diesAt;
    private final int partOfAWrite; // bytes of the write at which it dies that still come to the file
    int steps;
    boolean full;

    /** The death of the process. */
    static final class Death extends Error {
        private static final long serialVersionUID = 1;
    }

    FailingDisk(int diesAt, int partOfAWrite) {
        this.diesAt = diesAt;
        this.partOfAWrite = partOfAWrite;
    }

    private void step() {
        if (steps >= diesAt) {
            throw new Death();
        }
        steps++;
    }

    private void checkRoom() throws IOException {
        if (full) {
            throw new IOException("No space left on device");
        }
    }

    @Override
    FileChannel open(Path file) throws IOException {
        step();
        FileChannel channel = super.open(file);
        paths.put(channel, file);
        forcedBytes.putIfAbsent(file, channel.size());
        return channel;
    }

    @Override
    FileChannel create(Path file) throws IOException {
        step();
        checkRoom();
        FileChannel channel = super.create(file);
        paths.put(channel, file);
        forcedBytes.put(file, 0L);
        return channel;
    }

    @Override
    void write(FileChannel channel, byte[] content) throws IOException {
        if (steps == diesAt) {
            super.write(channel, java.util.Arrays.copyOf(content, Math.min(partOfAWrite, content.length - 1)));
        }
        step();
        checkRoom();
        super.write(channel, content);
    }

    @Override
    void force(FileChannel channel) throws IOException {
        step();
        forcedBytes.put(paths.get(channel), channel.size());
    }

    @Override
    void rename(Path from, Path to) throws IOException {
        step();
        super.rename(from, to);
        unforcedNames.put(to, from);
        forcedBytes.put(to, forcedBytes.remove(from));
        paths.replaceAll((channel, path) -> path.equals(from) ? to : path);
    }

    @Override
    void forceFolder(Path folder) {
        step();
        unforcedNames.clear();
        unforcedDeletes.clear();
    }

    @Override
    void delete(Path file) throws IOException {
        step();
        if (Files.exists(file)) {
            unforcedDeletes.put(file, Files.readAllBytes(file));
        }
        super.delete(file);
    }

    /** Whether a file outlives the loss of the power for certain. */
    boolean hasForced(Path file) {
        return forcedBytes.getOrDefault(file, 0L) > 0 && !unforcedNames.containsKey(file);
    }

    /** The power goes: of what was not forced, any part is lost. */
    void losePower(Random random) throws IOException {
        List<FileChannel> open = new ArrayList<>(paths.keySet());
        for (FileChannel channel : open) {
            channel.close();
        }
        for (Map.Entry<Path, Long> file : forcedBytes.entrySet()) {
            if (Files.exists(file.getKey())) {
                long more = Files.size(file.getKey()) - file.getValue();
                long kept = file.getValue() + (more > 0 ? random.nextInt((int) more + 1) : 0);
                try (FileChannel channel = FileChannel.open(file.getKey(), StandardOpenOption.WRITE)) {
                    channel.truncate(kept);
                }
            }
        }
        for (Map.Entry<Path, byte[]> deleted : unforcedDeletes.entrySet()) {
            if (random.nextBoolean()) {
                Files.write(deleted.getKey(), deleted.getValue());
            }
        }
        for (Map.Entry<Path, Path> name : unforcedNames.entrySet()) {
            if (random.nextBoolean()) {
                Files.move(name.getKey(), name.getValue(), StandardCopyOption.REPLACE_EXISTING);
            }
        }
    }

    /** The process dies. */
    void close() throws IOException {
        for (FileChannel channel : paths.keySet()) {
            channel.close();
        }
    }
}
