package org.sami.crw.report;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;

/** How rows of a report are kept in the temporary file of a {@link SpooledList}; nothing else reads them. */
public final class RowFormats {
    /** Firings. */
    public static final SpooledList.Format<FiringResult> FIRING = new SpooledList.Format<>() {
        @Override
        public void write(FiringResult row, DataOutputStream out) throws IOException {
            out.writeLong(row.number());
            out.writeLong(row.input());
            out.writeLong(row.atMillis());
            out.writeLong(row.mission());
            text(row.plan(), out);
            text(row.transition(), out);
            text(row.events(), out);
            text(row.moves(), out);
        }

        @Override
        public FiringResult read(DataInputStream in) throws IOException {
            return new FiringResult(
                    in.readLong(), in.readLong(), in.readLong(), in.readLong(), text(in), text(in), text(in), text(in));
        }
    };

    /** Questions to the operator. */
    public static final SpooledList.Format<DecisionResult> DECISION = new SpooledList.Format<>() {
        @Override
        public void write(DecisionResult row, DataOutputStream out) throws IOException {
            out.writeLong(row.id());
            out.writeLong(row.mission());
            text(row.type(), out);
            text(row.prompt(), out);
            out.writeLong(row.openedAtMillis());
            out.writeBoolean(row.closedAtMillis().isPresent());
            out.writeLong(row.closedAtMillis().orElse(0));
            text(row.by(), out);
            text(row.answer(), out);
            out.writeInt(row.clicks());
        }

        @Override
        public DecisionResult read(DataInputStream in) throws IOException {
            return new DecisionResult(
                    in.readLong(),
                    in.readLong(),
                    text(in),
                    text(in),
                    in.readLong(),
                    moment(in),
                    text(in),
                    text(in),
                    in.readInt());
        }

        private static OptionalLong moment(DataInputStream in) throws IOException {
            boolean known = in.readBoolean();
            long millis = in.readLong();
            return known ? OptionalLong.of(millis) : OptionalLong.empty();
        }
    };

    /** What sensors measured. */
    public static final SpooledList.Format<ReadingResult> READING = new SpooledList.Format<>() {
        @Override
        public void write(ReadingResult row, DataOutputStream out) throws IOException {
            out.writeLong(row.atMillis());
            text(row.boat(), out);
            text(row.sensor(), out);
            text(row.channel(), out);
            out.writeInt(row.values().size());
            for (double value : row.values()) {
                out.writeDouble(value);
            }
            text(row.unit(), out);
            out.writeDouble(row.latDeg());
            out.writeDouble(row.lonDeg());
        }

        @Override
        public ReadingResult read(DataInputStream in) throws IOException {
            return new ReadingResult(
                    in.readLong(),
                    text(in),
                    text(in),
                    text(in),
                    values(in),
                    text(in),
                    in.readDouble(),
                    in.readDouble());
        }

        private static List<Double> values(DataInputStream in) throws IOException {
            int count = in.readInt();
            List<Double> values = new ArrayList<>(count);
            for (int i = 0; i < count; i++) {
                values.add(in.readDouble());
            }
            return values;
        }
    };

    private RowFormats() {}

    private static void text(String text, DataOutputStream out) throws IOException {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        out.writeInt(bytes.length);
        out.write(bytes);
    }

    private static String text(DataInputStream in) throws IOException {
        return new String(in.readNBytes(in.readInt()), StandardCharsets.UTF_8);
    }
}
