package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** One page of the list of files that a boat keeps. */
public final class FileList extends FileAnswer {
    static final String TYPE = "files";

    /** Most files of one page, so that a page is not much longer than a piece. */
    public static final int MAX_FILES = 30;

    private final List<KeptFile> files;
    private final boolean more;

    /**
     * A page.
     *
     * @param files at most {@link #MAX_FILES}, in the order of their names
     * @param more whether others follow
     */
    public FileList(String requestId, List<KeptFile> files, boolean more) {
        super(requestId);
        if (files.size() > MAX_FILES) {
            throw new Checks.BadValueException("files", files.size() + " are more than " + MAX_FILES);
        }
        this.files = Collections.unmodifiableList(new ArrayList<>(files));
        this.more = more;
    }

    static FileList read(Fields in) throws LinkException {
        List<KeptFile> files = new ArrayList<>();
        for (Fields row : in.objects("files", MAX_FILES)) {
            try {
                files.add(KeptFile.read(row));
            } catch (Checks.BadValueException e) {
                throw row.refused(e);
            }
        }
        return new FileList(in.text("request"), files, in.flag("more"));
    }

    /** The files of this page. */
    public List<KeptFile> files() {
        return files;
    }

    /** Whether others follow; they are asked for with the name of the last one. */
    public boolean more() {
        return more;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void writeAnswer(JsonGenerator out) throws IOException {
        out.writeArrayFieldStart("files");
        for (KeptFile file : files) {
            file.write(out);
        }
        out.writeEndArray();
        out.writeBooleanField("more", more);
    }
}
