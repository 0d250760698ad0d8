package org.sami.dreamm.file;

import java.io.IOException;
import java.io.Reader;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Properties;
import java.util.stream.Stream;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;
import org.sami.ui.window.DirectoryLock;

/**
 * Where a process keeps unsaved work in case it is killed: a numbered folder of its own, held by a lock, below one that all processes
 * share. What lies in a folder that nobody holds was left behind. Its methods may be called on any one thread at a time.
 */
public final class RecoveryFolder implements AutoCloseable {
    private static final int MOST = 1000;
    private static final String PROJECT = "unsaved.json";
    private static final String ABOUT = "unsaved.properties";
    private static final String FILE = "file";

    private final Path folder;
    private final DirectoryLock lock;
    private final Vocabulary vocabulary;

    private RecoveryFolder(Path folder, DirectoryLock lock, Vocabulary vocabulary) {
        this.folder = folder;
        this.lock = lock;
        this.vocabulary = vocabulary;
    }

    /**
     * Takes a folder in which nothing was left behind.
     *
     * @param shared the folder of all processes
     */
    public static RecoveryFolder take(Path shared, Vocabulary vocabulary) throws IOException {
        for (int i = 1; i <= MOST; i++) {
            Path folder = shared.resolve(Integer.toString(i));
            Optional<DirectoryLock> lock = DirectoryLock.take(folder);
            if (lock.isPresent() && !Files.exists(folder.resolve(PROJECT))) {
                return new RecoveryFolder(folder, lock.get(), Objects.requireNonNull(vocabulary, "vocabulary"));
            }
            if (lock.isPresent()) {
                lock.get().close();
            }
        }
        throw new IOException("there is too much unsaved work in " + shared);
    }

    /** What processes that are gone have left behind, the newest first. */
    public static List<UnsavedWork> leftBehind(Path shared) throws IOException {
        List<UnsavedWork> left = new ArrayList<>();
        if (!Files.isDirectory(shared)) {
            return left;
        }
        List<Path> folders;
        try (Stream<Path> all = Files.list(shared)) {
            folders = all.filter(folder -> Files.isRegularFile(folder.resolve(PROJECT)))
                    .toList();
        }
        for (Path folder : folders) {
            Optional<DirectoryLock> lock = DirectoryLock.take(folder);
            if (lock.isPresent()) {
                Path project = folder.resolve(PROJECT);
                left.add(new UnsavedWork(
                        folder,
                        project,
                        file(folder),
                        Files.getLastModifiedTime(project).toInstant()));
                lock.get().close();
            }
        }
        left.sort((a, b) -> b.time().compareTo(a.time()));
        return left;
    }

    private static Optional<Path> file(Path folder) throws IOException {
        Properties about = new Properties();
        if (Files.exists(folder.resolve(ABOUT))) {
            try (Reader reader = Files.newBufferedReader(folder.resolve(ABOUT))) {
                about.load(reader);
            } catch (IllegalArgumentException unfit) {
                throw new IOException(folder.resolve(ABOUT) + " cannot be read", unfit);
            }
        }
        return Optional.ofNullable(about.getProperty(FILE)).map(Path::of);
    }

    /** Deletes the remaining work of a dead process, once it is kept elsewhere or given up. */
    public static void forget(UnsavedWork work) throws IOException {
        Files.deleteIfExists(work.project());
        Files.deleteIfExists(work.folder().resolve(ABOUT));
    }

    /** Keeps a project as it is now; it is on disk when this returns. */
    void keep(Project project, Optional<Path> file) throws IOException {
        Properties about = new Properties();
        file.ifPresent(path -> about.setProperty(FILE, path.toString()));
        try (Writer writer = Files.newBufferedWriter(folder.resolve(ABOUT))) {
            about.store(writer, null);
        }
        new ProjectWriter(vocabulary).write(project, folder.resolve(PROJECT));
    }

    /** Nothing is unsaved any longer. */
    void clear() throws IOException {
        Files.deleteIfExists(folder.resolve(PROJECT));
        Files.deleteIfExists(folder.resolve(ABOUT));
    }

    /** Gives the folder up; what is kept in it stays. */
    @Override
    public void close() throws IOException {
        lock.close();
    }
}
