package org.sami.boat.server.log;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The files of one boat's log: {@code NAME.log}, then {@code NAME.log.000001} and so on. A file keeps its name: the boat writes to the one with the highest
 * number, and the oldest ones go.
 */
public final class LogFiles {
    private static final Pattern NUMBERED = Pattern.compile("(.+)\\.\\d{6,9}");
    private static final int MOST_NUMBER = 999_999_999;

    private final Path first;
    private final Pattern names;
    private final Pattern parts;

    /** The log whose first file is or was this one. */
    public LogFiles(Path first) {
        this.first = first.toAbsolutePath();
        String name = Pattern.quote(String.valueOf(first.getFileName()));
        names = Pattern.compile(name + "(?:\\.(\\d{6,9}))?");
        parts = Pattern.compile(name + "\\.\\d{6,9}\\.part");
    }

    /** The log to which a file belongs, whichever of its files that is. */
    public static LogFiles of(Path file) {
        Matcher numbered = NUMBERED.matcher(String.valueOf(file.getFileName()));
        return new LogFiles(numbered.matches() ? file.resolveSibling(numbered.group(1)) : file);
    }

    /** The folder that the files are in. */
    public Path folder() {
        return Objects.requireNonNull(first.getParent(), "a log stands in a folder");
    }

    /** Whether a file of the folder belongs to the log. */
    public boolean isOne(String name) {
        return names.matcher(name).matches();
    }

    /** The files that are there by their numbers, the first one's being 0. */
    public SortedMap<Integer, Path> byNumber() throws IOException {
        SortedMap<Integer, Path> all = new TreeMap<>();
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder())) {
            for (Path file : files) {
                Matcher name = names.matcher(String.valueOf(file.getFileName()));
                if (name.matches() && Files.isRegularFile(file)) {
                    all.put(name.group(1) == null ? 0 : Integer.parseInt(name.group(1)), file);
                }
            }
        }
        return all;
    }

    /** Files that a boat was beginning when it ended. */
    List<Path> unfinished() throws IOException {
        List<Path> all = new ArrayList<>();
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder())) {
            for (Path file : files) {
                if (parts.matcher(String.valueOf(file.getFileName())).matches()) {
                    all.add(file);
                }
            }
        }
        return all;
    }

    /** The file of a number. */
    Path file(int number) {
        if (number > MOST_NUMBER) {
            throw new IllegalStateException("a log of more than " + MOST_NUMBER + " files");
        }
        return number == 0
                ? first
                : first.resolveSibling(first.getFileName() + String.format(Locale.ROOT, ".%06d", number));
    }

    /** Where a file is written until it is whole. */
    Path part(int number) {
        Path file = file(number);
        return file.resolveSibling(file.getFileName() + ".part");
    }

    /** The oldest files before one, so many that the others before it have no more bytes than these. */
    List<Path> over(int number, long bytes) throws IOException {
        List<Path> closed = new ArrayList<>(byNumber().headMap(number).values());
        Collections.reverse(closed);
        List<Path> over = new ArrayList<>();
        long sum = 0;
        for (Path file : closed) {
            sum += Files.size(file);
            if (sum > bytes) {
                over.add(file);
            }
        }
        return over;
    }
}
